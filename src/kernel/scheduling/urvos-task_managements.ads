--  SPDX-License-Identifier: Apache-2.0

--  The tasks of one processor with what finds the next one quickly (report,
--  sections 2.2 and 3.3; FRM-2 to FRM-4, KRN-1 to KRN-4). Each call is one of
--  URVOS.Schedulers.Calls. URVOS.Executives has one management for each
--  processor.

with URVOS.Frames;           use URVOS.Frames;
with URVOS.Schedulers;       use URVOS.Schedulers;
with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;
with URVOS.Task_Trees;       use URVOS.Task_Trees;

package URVOS.Task_Managements with Pure, SPARK_Mode is

   --  For each minor frame, the TCBs of tasks that are released in it.
   type Release_Table is array (Minor_Frame) of TCB_Range
   with Alignment => 2;

   function Release_Frame (Release : Tick) return Minor_Frame is
     (Minor_Frame (Release mod Ticks_Per_Major_Frame));

   --  A table has all sleeping tasks.
   function Sleepers_Are_In
     (S : Scheduler; Table : Release_Table) return Boolean
   is
     (for all Which in TCB_Number =>
        (if Queue_Of (S, Which) = Timer
         then Is_In
           (Which, Table (Release_Frame (TCB (S, Which).Ready_At)))));

   --  A place in the major frame, or none: it is not known.
   type Frame_Place is range 0 .. Ticks_Per_Major_Frame with Size => 8;

   Unknown : constant Frame_Place := Ticks_Per_Major_Frame;

   function Place_Of (Now : Clock_Tick) return Frame_Place is
     (Frame_Place (Minor_Frame_Of (Now)));

   --  A search looks only at May_Be_Ready, which has all ready TCBs, and each
   --  tick adds those of its minor frame: a task mostly has the same minor
   --  frame in each major frame. Place is the clock's: no tick or release of
   --  the usual kind needs a division.
   type Management is record
      Tasks        : Scheduler;
      May_Be_Ready : TCB_Range     := No_TCBs;
      Released_In  : Release_Table := (others => No_TCBs);
      Place        : Frame_Place   := Unknown;
   end record
   with
     Predicate =>
       Ready_Are_In (Tasks, May_Be_Ready)
       and then Sleepers_Are_In (Tasks, Released_In)
       and then (Place = Unknown or else Place = Place_Of (Clock (Tasks)));

   --  The release of a task with this offset in the next major frame.
   function Release_Of (This : Management; Offset : Minor_Frame) return Tick is
     (if This.Place = Unknown
      then Next_Release (Clock (This.Tasks), Offset)
      else Clock (This.Tasks)
        + Tick
            (Ticks_Per_Major_Frame + Frame_Place'Base (Offset) - This.Place))
   with
     Post =>
       Release_Of'Result = Next_Release (Clock (This.Tasks), Offset)
       and then Release_Frame (Release_Of'Result) = Offset
       and then Release_Of'Result > Clock (This.Tasks);

   --  Loads the tasks of a tree and runs the first one. The tasks that were
   --  there before are gone.
   procedure Start
     (This : out Management; Tree : Task_Tree; Now : Clock_Tick)
   with
     Post =>
       This.Tasks = After_Dispatch (Loaded_Tree (Tree, Now))
       and then Clock (This.Tasks) = Now;

   --  Sets the time, unless the clock runs back.
   procedure Follow_Clock (This : in out Management; Now : Clock_Tick)
   with
     Post =>
       This.Tasks =
         After_Wake
           (This'Old.Tasks, Tick'Max (Clock (This'Old.Tasks), Now))
       and then Running_TCB (This.Tasks) = Running_TCB (This'Old.Tasks)
       and then
         Clock (This.Tasks) = Tick'Max (Clock (This'Old.Tasks), Now);

   --  A task may be ready: an idle processor has to search.
   function Has_Candidate (This : Management) return Boolean is
     (This.May_Be_Ready /= No_TCBs)
   with
     Post =>
       Has_Candidate'Result
       or else After_Dispatch (This.Tasks) = This.Tasks;

   --  Gives an idle processor to the next task, if any.
   procedure Search (This : in out Management)
   with
     Inline,
     Post =>
       This.Tasks = After_Dispatch (This'Old.Tasks)
       and then Clock (This.Tasks) = Clock (This'Old.Tasks);

   --  The running task sleeps until a tick of the minor frame Released_In.
   procedure Put_To_Sleep
     (This        : in out Management;
      Until_Tick  : Tick;
      Released_In : Minor_Frame)
   with
     Inline,
     Pre  =>
       not Is_Idle (This.Tasks)
       and then Released_In =
         Release_Frame (Tick'Max (Until_Tick, Clock (This.Tasks) + 1)),
     Post =>
       This.Tasks = After_Sleep (This'Old.Tasks, Until_Tick)
       and then Clock (This.Tasks) = Clock (This'Old.Tasks);

   --  The running task gives the processor to a ready task of higher priority,
   --  if any.
   procedure Give_Way (This : in out Management)
   with
     Inline,
     Pre  => not Is_Idle (This.Tasks),
     Post =>
       This.Tasks = After_Exit (This'Old.Tasks)
       and then Clock (This.Tasks) = Clock (This'Old.Tasks)
       and then not Is_Idle (This.Tasks);

   --  The running task ends.
   procedure End_Task (This : in out Management)
   with
     Inline,
     Pre  => not Is_Idle (This.Tasks),
     Post =>
       This.Tasks = After_Terminate (This'Old.Tasks)
       and then Clock (This.Tasks) = Clock (This'Old.Tasks);

end URVOS.Task_Managements;
