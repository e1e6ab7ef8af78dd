--  Who sleeps until when (report, section 3.3; FRM-3, FRM-4).
--
--  A task that has done its transaction sleeps until a tick. It is due from
--  that tick on, and late when the clock has already passed it.

with URVOS.Frames; use URVOS.Frames;

generic
   type Task_Name is (<>);
package URVOS.Sleepers with Pure, SPARK_Mode is

   type Sleeper_List is array (Task_Name) of Tick;

   function Is_Due
     (List : Sleeper_List;
      Who  : Task_Name;
      Now  : Clock_Tick) return Boolean
   is (List (Who) <= Now);

   function Is_Late
     (List : Sleeper_List;
      Who  : Task_Name;
      Now  : Clock_Tick) return Boolean
   is (List (Who) < Now);

   --  Who sleeps until the given tick; nobody else's sleep changes.
   procedure Sleep
     (List       : in out Sleeper_List;
      Who        : Task_Name;
      Until_Tick : Tick)
   with
     Global => null,
     Post   => List = (List'Old with delta Who => Until_Tick);

end URVOS.Sleepers;
