--  SPDX-License-Identifier: Apache-2.0

with URVOS.Schedulers;       use URVOS.Schedulers;
with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;

package body URVOS.Executives
  with
    SPARK_Mode,
    Refined_State => (Task_Management => (Present, Late))
is

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

   Present : Management;
   Late    : Count := 0;

   Tasks : Scheduler renames Present.Tasks;

   --  Between two ticks each task sleeps at most once, and before one of them
   --  sleeps it gives way at most once to each task of higher priority.
   Steps_Per_Tick : constant := Number_Of_TCBs * (Number_Of_TCBs + 1);

   --  The release of a task with this offset in the next major frame.
   function Release_Of (Offset : Minor_Frame) return Tick is
     (if Present.Place = Unknown then Next_Release (Clock (Tasks), Offset)
      else Clock (Tasks)
        + Tick
            (Ticks_Per_Major_Frame + Frame_Place'Base (Offset)
             - Present.Place))
   with Post => Release_Of'Result = Next_Release (Clock (Tasks), Offset);

   --  Reports an overrun of a TCB's task if the scheduler has counted one
   --  since Before.
   procedure Note_Overrun (Before : Count; Which : TCB_Number);

   --  Sets the time, unless the clock runs back.
   procedure Follow_Clock (Now : Clock_Tick)
   with
     Inline,
     Post =>
       Running_TCB (Tasks) = Running_TCB (Present'Old.Tasks)
       and then
         Clock (Tasks) = Tick'Max (Clock (Present'Old.Tasks), Now);

   --  Gives an idle processor to the next task.
   procedure Choose
   with Inline, Post => Clock (Tasks) = Clock (Tasks)'Old;

   --  The same. It is out of line, for a tick at which no task is due.
   procedure Search
   with Post => Clock (Tasks) = Clock (Tasks)'Old;

   --  The running task, the caller, sleeps until a tick of the minor frame
   --  Released_In.
   procedure Put_To_Sleep
     (Caller      : TCB_Number;
      Until_Tick  : Tick;
      Released_In : Minor_Frame)
   with
     Inline,
     Pre  =>
       Caller = Running_TCB (Tasks)
       and then Released_In =
         Release_Frame (Tick'Max (Until_Tick, Clock (Tasks) + 1)),
     Post => Clock (Tasks) = Clock (Tasks)'Old;

   --  The running task, the caller, gives the processor to a ready task of
   --  higher priority, if any.
   procedure Give_Way (Caller : TCB_Number; Runs_On : out Boolean)
   with
     Pre  => Caller = Running_TCB (Tasks),
     Post => Clock (Tasks) = Clock (Tasks)'Old;

   procedure Note_Overrun (Before : Count; Which : TCB_Number) is
   begin
      if Overruns (Tasks) /= Before then
         Late := Incremented (Late);
         Report_Overrun (TCB (Tasks, Which).Id);
      end if;
   end Note_Overrun;

   procedure Follow_Clock (Now : Clock_Tick) is
      Place : Frame_Place;
   begin
      if Now = Clock (Tasks) + 1 and then Present.Place /= Unknown then
         Place :=
           (if Present.Place = Frame_Place (Minor_Frame'Last) then 0
            else Present.Place + 1);
         Present.May_Be_Ready :=
           (if Present.May_Be_Ready = No_TCBs
            then Present.Released_In (Minor_Frame (Place))
            else Union
              (Present.May_Be_Ready,
               Present.Released_In (Minor_Frame (Place))));
      elsif Now > Clock (Tasks) then
         Place := Place_Of (Now);
         Present.May_Be_Ready := All_TCBs;
      else
         return;
      end if;
      --  The place and the clock change together.
      Present.Place := Unknown;
      Wake (Tasks, Now);
      if Place /= Unknown then
         Present.Place := Place;
      end if;
   end Follow_Clock;

   procedure Search is
      Before       : constant Count := Overruns (Tasks);
      May_Be_Ready : TCB_Range      := Present.May_Be_Ready;
   begin
      Dispatch (Tasks, May_Be_Ready);
      Present.May_Be_Ready := May_Be_Ready;
      if not Is_Idle (Tasks) then
         Note_Overrun (Before, Running_TCB (Tasks));
      end if;
   end Search;

   procedure Choose is
   begin
      if Present.May_Be_Ready /= No_TCBs then
         Search;
      end if;
   end Choose;

   procedure Put_To_Sleep
     (Caller      : TCB_Number;
      Until_Tick  : Tick;
      Released_In : Minor_Frame)
   is
      Before : constant Count := Overruns (Tasks);
   begin
      if not Is_In (Caller, Present.Released_In (Released_In)) then
         Present.Released_In (Released_In) :=
           Union (Present.Released_In (Released_In), (Caller, Caller));
      end if;
      Sleep (Tasks, Until_Tick);
      Note_Overrun (Before, Caller);
      Choose;
   end Put_To_Sleep;

   procedure Give_Way (Caller : TCB_Number; Runs_On : out Boolean) is
      Before       : constant Count     := Overruns (Tasks);
      May_Be_Ready : constant TCB_Range := Present.May_Be_Ready;
   begin
      Present.May_Be_Ready := All_TCBs;
      Exit_Call (Tasks);
      Runs_On := Running_TCB (Tasks) = Caller;
      if Runs_On then
         Present.May_Be_Ready := May_Be_Ready;
      else
         Note_Overrun (Before, Running_TCB (Tasks));
      end if;
   end Give_Way;

   procedure Start (Tree : Task_Tree; Now : Clock_Tick) is
   begin
      Present.May_Be_Ready := All_TCBs;
      Present.Released_In := (others => All_TCBs);
      Present.Place := Unknown;
      Start (Tasks, Tree, Now);
      if (for all Which in TCB_Number => Queue_Of (Tasks, Which) /= Timer) then
         Present.Released_In := (others => No_TCBs);
      end if;
   end Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      Follow_Clock (Now);
      Choose;
   end Clock_Interrupt;

   function Time return Clock_Tick is (Clock (Tasks))
   with Refined_Global => Present;

   function Is_Idle return Boolean is (Is_Idle (Tasks))
   with Refined_Global => Present;

   procedure Run_Step (Runs_On : out Boolean) is
      Now       : Clock_Tick := Clock (Tasks);
      Has_Moved : Boolean    := False;
      Caller    : TCB_Number;
      Call      : Kernel_Call;
   begin
      Runs_On := False;
      if Is_Idle (Tasks) then
         return;
      end if;

      Caller := Running_TCB (Tasks);
      Step
        (TCB (Tasks, Caller).Id, TCB (Tasks, Caller).First_Run, Now, Call);
      Read_Clock (Now, Has_Moved);
      if Has_Moved then
         Follow_Clock (Now);
      end if;

      case Call.Name is
         when Kernel_Calls.Exit_Call =>
            Give_Way (Caller, Runs_On);

         when Sleep_Call =>
            Put_To_Sleep
              (Caller,
               Call.Until_Tick,
               Release_Frame (Tick'Max (Call.Until_Tick, Clock (Tasks) + 1)));

         when Next_Frame_Call =>
            Put_To_Sleep (Caller, Release_Of (Call.Offset), Call.Offset);

         when Terminate_Call =>
            Terminate_Caller (Tasks);
            Choose;
      end case;
   end Run_Step;

   procedure Run_Until_Idle is
      Runs_On : Boolean;
   begin
      for Number in 1 .. Steps_Per_Tick loop
         exit when Is_Idle (Tasks);
         Run_Step (Runs_On);
         exit when Runs_On;
      end loop;
   end Run_Until_Idle;

   function Overruns return Count is (Late)
   with Refined_Global => Late;

end URVOS.Executives;
