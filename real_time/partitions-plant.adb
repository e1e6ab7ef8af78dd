--  SPDX-License-Identifier: Apache-2.0

with Ada.Streams;                  use Ada.Streams;
with Ada.Characters.Latin_1;
with Ada.Exceptions;               use Ada.Exceptions;
with Ada.Strings.Unbounded;        use Ada.Strings.Unbounded;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with GNAT.OS_Lib;                  use GNAT.OS_Lib;
with Interfaces.C;                 use Interfaces.C;
with System;

with Host.Plant_Program;
with MCS;
with Partitions.Clocks;
with Partitions.Occurrences;
with Partitions.Reports;       use Partitions.Reports;
with Partitions.Signal_Masks;
with Partitions.System_Calls;  use Partitions.System_Calls;
with URVOS;                    use URVOS;

package body Partitions.Plant is

   Line    : File       := Invalid;
   Process : Process_Id := Invalid_Pid;

   --  From new commands for the servos to the row of the record; a whole frame
   --  when both are of the same tick.
   function Shown_After (Schedule : Schedule_Name) return Step_Count is
     ((Integer (MCS.Task_List (MCS.CORE_Task) (Schedule).Offset)
       - Servo_Tick (Schedule) - 1) mod Step_Count'Last + 1);

   type Plant_State is (In_Time, Is_Late, Is_Silent, Is_Dead);

   --  Scans without an answer, up to those of a second: the plant was then
   --  stopped, and the run has a fault.
   type Missed_Count is
     range 0 .. Microseconds_Per_Second / Major_Frame;

   --  There are commands for the next frame.
   Requested : Suspension_Object;

   protected Aircraft is

      procedure Settle (Words : Sensor_Words; State : Shown_State);

      --  The node has new words for the servos.
      procedure Ask (Servos : PWM_Buffer);

      function Servos return PWM_Buffer;

      procedure Answer (Words : Sensor_Words; State : Shown_State);

      --  A scan begins. Missed: it has the words of the one before; Answers is
      --  that of Partitions.Plant.Look.
      procedure Look
        (Words   : out Sensor_Words;
         Missed  : out Boolean;
         Answers : out Boolean);

      --  Is_First is False when the death was known.
      procedure Die (Is_First : out Boolean; Diverged : Boolean := False);

      --  True if the cause was numbers that are not finite.
      function Has_Diverged return Boolean;

      --  The number of times it did not answer for a second.
      function Times_Still return URVOS.Count;

      function State return Plant_State;
      function Frames return URVOS.Count;
      function Present return Shown_State;

   private
      Shown    : Shown_State  := (others => 0.0);
      Sensors  : Sensor_Words := Neutral_Sensors;
      Commands : PWM_Buffer   := Safe_Outputs;
      Flying   : Boolean      := False;   --  an answer is expected
      Now      : Plant_State  := In_Time;
      Missing  : Missed_Count := 0;       --  scans in a row
      Still    : URVOS.Count  := 0;       --  times
      Flown    : URVOS.Count  := 0;
      Wrong    : Boolean      := False;   --  numbers are not finite
   end Aircraft;

   Lates  : Occurrences.Occurrence;
   Deaths : Occurrences.Occurrence;

   --  Used by the environment task.
   Reported : Plant_State := In_Time;

   protected body Aircraft is

      procedure Settle (Words : Sensor_Words; State : Shown_State) is
      begin
         Shown := State;
         Sensors := Words;
      end Settle;

      --  One frame at a time: an unfinished frame continues.
      procedure Ask (Servos : PWM_Buffer) is
      begin
         if not Flying and then Now /= Is_Dead then
            Commands := Servos;
            Flying := True;
            Set_True (Requested);
         end if;
      end Ask;

      function Servos return PWM_Buffer is (Commands);

      procedure Answer (Words : Sensor_Words; State : Shown_State) is
      begin
         Shown := State;
         Sensors := Words;
         Flying := False;
         Flown := Incremented (Flown);
      end Answer;

      procedure Look
        (Words   : out Sensor_Words;
         Missed  : out Boolean;
         Answers : out Boolean) is
      begin
         Words := Sensors;
         Missed := Flying and then Now /= Is_Dead;
         if not Missed then
            Missing := 0;
         elsif Missing < Missed_Count'Last then
            Missing := Missing + 1;
            if Missing = Missed_Count'Last then
               Still := URVOS.Incremented (Still);
            end if;
         end if;
         if Now /= Is_Dead then
            Now :=
              (case Missing is
                  when 0                => In_Time,
                  when 1 .. Most_Missed => Is_Late,
                  when others           => Is_Silent);
         end if;
         Answers := Now in In_Time | Is_Late;
      end Look;

      procedure Die (Is_First : out Boolean; Diverged : Boolean := False) is
      begin
         Is_First := Now /= Is_Dead;
         if Is_First then
            Wrong := Diverged;
         end if;
         Now := Is_Dead;
      end Die;

      function Has_Diverged return Boolean is (Wrong);

      function Times_Still return URVOS.Count is (Still);

      function State return Plant_State is (Now);

      function Frames return URVOS.Count is (Flown);

      function Present return Shown_State is (Shown);

   end Aircraft;

   --  Is_Good is False when the process has ended.
   procedure Send (Message : Stream_Element_Array; Is_Good : out Boolean);
   procedure Receive
     (Message : out Stream_Element_Array; Is_Good : out Boolean);

   --  Receives the bytes up to the next line feed.
   procedure Receive_Line
     (Text : out Unbounded_String; Is_Good : out Boolean);

   procedure Send (Message : Stream_Element_Array; Is_Good : out Boolean) is
      Next : Stream_Element_Offset := Message'First;
      Sent : Byte_Total;
   begin
      while Next <= Message'Last loop
         Sent := System_Calls.Send
           (Line, Message (Next)'Address, size_t (Message'Last - Next + 1),
            No_Signal);
         exit when Sent <= 0;
         Next := Next + Stream_Element_Offset (Sent);
      end loop;
      Is_Good := Next > Message'Last;
   end Send;

   procedure Receive
     (Message : out Stream_Element_Array; Is_Good : out Boolean)
   is
      Next : Stream_Element_Offset := Message'First;
      Came : Byte_Total;
   begin
      Message := (others => 0);
      while Next <= Message'Last loop
         Came := System_Calls.Receive
           (Line, Message (Next)'Address, size_t (Message'Last - Next + 1),
            0);
         exit when Came <= 0;
         Next := Next + Stream_Element_Offset (Came);
      end loop;
      Is_Good := Next > Message'Last;
   end Receive;

   procedure Receive_Line
     (Text : out Unbounded_String; Is_Good : out Boolean)
   is
      Next : Stream_Element_Array (1 .. 1);
   begin
      Text := Null_Unbounded_String;
      loop
         Receive (Next, Is_Good);
         exit when not Is_Good
           or else Character'Val (Next (1)) = Ada.Characters.Latin_1.LF;
         Append (Text, Character'Val (Next (1)));
      end loop;
   end Receive_Line;

   --  Starts the process with its end of a connection. It inherits only that
   --  end, so that each side sees when the other one has ended.
   procedure Spawn;

   procedure Spawn is
      Made   : File_Pair;
      Theirs : File;
      Closed : int;
   begin
      if Socket_Pair (Local_Family, Stream + Close_On_Exec, 0, Made)
           = Failed
      then
         Host.Plant_Program.Refuse ("no connection: " & Errno_Message);
      end if;
      Line := Made (1);
      Theirs := Duplicate (Made (2));

      --  It inherits the blocked signals, too: Ctrl-C is for this program.
      Signal_Masks.Block;
      Host.Plant_Program.Spawn (Natural (Theirs), Process);
      Signal_Masks.Let_End;
      Closed := int'Min (Close (Theirs), Close (Made (2)));
      pragma Unreferenced (Closed);
   end Spawn;

   --  Python and JSBSim may have to be read from the disk (SIM-9).
   First_Answer_In : constant System_Calls.Time_Span :=
     (Seconds => 60, Nanoseconds => 0);

   --  False when no answer begins in that time.
   function Begins_To_Answer return Boolean;

   function Begins_To_Answer return Boolean is
      Requests : Poll_Requests := (1 => (Line, Input_Ready, 0));
   begin
      return Poll
        (Requests'Address, 1, First_Answer_In, System.Null_Address) > 0;
   end Begins_To_Answer;

   procedure Start (Schedule : Schedule_Name) is
      Answer  : Unbounded_String;
      Message : State_Message;
      Sensors : Sensor_Words;
      State   : Flight_State;
      Shown   : Shown_State;
      Is_Good : Boolean;
   begin
      Spawn;
      Send
        (Introduction (Shown_After (Schedule), Schedule => Schedule),
         Is_Good);
      if Is_Good and then not Begins_To_Answer then
         Stop;
         Host.Plant_Program.Refuse_Flight
           ("JSBSim's process has not answered for 60 s");
      end if;
      if Is_Good then
         Receive_Line (Answer, Is_Good);
      end if;
      if Is_Good and then Answer /= Ready then
         Host.Plant_Program.Refuse_Flight (To_String (Answer));
      end if;
      if Is_Good then
         Receive (Message, Is_Good);
      end if;
      if not Is_Good then
         Host.Plant_Program.Refuse ("plant.py has failed");
      end if;
      Read (Message, Sensors, State, Shown);
      pragma Unreferenced (State);
      Aircraft.Settle (Sensors, Shown);

   exception
      when Error : Not_Finite =>
         Host.Plant_Program.Refuse_Flight (Exception_Message (Error));
   end Start;

   function Is_Present return Boolean is (Line /= Invalid);

   function Truth return Shown_State is (Aircraft.Present);

   procedure Fly (Servos : PWM_Buffer; Heard : Boolean) is
   begin
      if Is_Present and then Heard then
         Aircraft.Ask (Servos);
      end if;
   end Fly;

   procedure Look (Sensors : out Sensor_Words; Answers : out Boolean) is
      Missed : Boolean;
   begin
      Aircraft.Look (Sensors, Missed, Answers);
      if Missed then
         Lates.Add (Clocks.Elapsed);
      end if;
   end Look;

   --  The process has ended, or its aircraft has diverged.
   procedure Note_Death (Diverged : Boolean := False);

   procedure Note_Death (Diverged : Boolean := False) is
      Is_First : Boolean;
   begin
      Aircraft.Die (Is_First, Diverged);
      if Is_First then
         Deaths.Add (Clocks.Elapsed);
      end if;
   end Note_Death;

   --  Flies one frame.
   procedure Fly_Frame (Servos : PWM_Buffer; Is_Good : out Boolean);

   procedure Fly_Frame (Servos : PWM_Buffer; Is_Good : out Boolean) is
      Message : State_Message;
      Sensors : Sensor_Words;
      State   : Flight_State;
      Shown   : Shown_State;
   begin
      Send (To_Message (Servos), Is_Good);
      if Is_Good then
         Receive (Message, Is_Good);
      end if;
      if Is_Good then
         Read (Message, Sensors, State, Shown);
         pragma Unreferenced (State);
         Aircraft.Answer (Sensors, Shown);
      end if;

   exception
      when Not_Finite =>
         Note_Death (Diverged => True);
         Is_Good := False;
   end Fly_Frame;

   task Flight;

   task body Flight is
      Is_Good : Boolean;
   begin
      loop
         Suspend_Until_True (Requested);
         Fly_Frame (Aircraft.Servos, Is_Good);
         if not Is_Good then
            Note_Death;
         end if;
      end loop;
   end Flight;

   --  The plant gets no commands while the ground is not heard, but may die
   --  even then.
   procedure Look_After_Plant;

   procedure Look_After_Plant is
      Next : Stream_Element_Array (1 .. 1);
   begin
      if Is_Present
        and then System_Calls.Receive
          (Line, Next'Address, Next'Length, Leave_There + Dont_Wait) = 0
      then
         Note_Death;
      end if;
   end Look_After_Plant;

   function Next_Message (Now : String) return String is
      State   : Plant_State;
      Changed : Boolean;
   begin
      Look_After_Plant;
      State := Aircraft.State;
      if State = Is_Silent and then Reported = In_Time then
         State := Is_Late;   --  reports that first; the rest at the next row
      end if;
      Changed := State /= Reported;
      Reported := State;
      return
        (if not Changed then ""
         else
           (case State is
               when In_Time => "plant in time again at " & Now & " s",
               when Is_Late => "plant late at " & Now
                               & " s: the sensors stand still",
               when Is_Silent => "plant does not answer at " & Now
                                 & " s: its sensors are old",
               when Is_Dead => (if Aircraft.Has_Diverged
                                then "plant has diverged at "
                                else "plant has died at ") & Now
                               & " s: its sensors are old"));
   end Next_Message;

   function Failure return String is
     (case Aircraft.State is
         when In_Time | Is_Late =>
           (if Aircraft.Times_Still = 0 then ""
            else "--plant jsbsim: JSBSim's process stood still"),
         when Is_Silent =>
           "--plant jsbsim: JSBSim's process does not answer",
         when Is_Dead =>
           (if Aircraft.Has_Diverged
            then "--plant jsbsim: the aircraft's numbers are not finite"
            else "--plant jsbsim: JSBSim's process has ended"));

   procedure Put_Counts
     (Result : in out Partitions.Reports.Report;
      To     : in out Host.Text_Output.Writer) is
   begin
      if Is_Present then
         Begin_Group (Result, To, "plant");
         Put_Field (Result, To, "frames", Reports.Number (Aircraft.Frames));
         Put_Field
           (Result, To, "late", Reports.Number (Lates.Contents.Number));
         Put_Field
           (Result, To, "died", Reports.Number (Deaths.Contents.Number));
         Put_Field
           (Result, To, "stood_still", Reports.Number (Aircraft.Times_Still));
         End_Group (Result, To);
      end if;
   end Put_Counts;

   procedure Put_Events (To : in out Host.Text_Output.Writer) is
   begin
      Occurrences.Write (To, Host.Aircraft, "plant_late", Lates.Contents);
      Occurrences.Write (To, Host.Aircraft, "plant_died", Deaths.Contents);
   end Put_Events;

   procedure Stop is
   begin
      if Process /= Invalid_Pid then
         Kill (Process);
         Process := Invalid_Pid;
      end if;
   end Stop;

end Partitions.Plant;
