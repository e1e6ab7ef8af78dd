--  Runs the tasks of a node at their places in the major frame (report,
--  sections 2.2 and 3.3; FRM-2 to FRM-4).
--
--  A task runs one transaction, then sleeps until its offset in the next
--  major frame. Tasks due at the same tick run in the order of their names.
--  A task that was released after its tick is an overrun.

with URVOS.Frames; use URVOS.Frames;

generic
   type Task_Name is (<>);

   --  The minor frame in which a task is released.
   type Offset_Table is array (Task_Name) of Minor_Frame;
   Offsets : Offset_Table;

   with procedure Run_Transaction (Who : Task_Name);
package URVOS.Executives
  with
    SPARK_Mode,
    Abstract_State => Sleepers,
    Initializes    => Sleepers
is

   --  Every task sleeps until its place in the major frame after Now. No
   --  overrun has been counted.
   procedure Start (Now : Clock_Tick)
   with
     Global => (Output => Sleepers),
     Post   =>
       (for all Who in Task_Name =>
          Wake_Up (Who) = Next_Release (Now, Offsets (Who)))
       and then Overruns = 0;

   --  Runs the tasks that are due.
   procedure Run_Due_Tasks (Now : Clock_Tick);

   --  The tick until which a task sleeps.
   function Wake_Up (Who : Task_Name) return Tick
   with Global => Sleepers;

   --  How often a task was released late.
   function Overruns return Count
   with Global => Sleepers;

end URVOS.Executives;
