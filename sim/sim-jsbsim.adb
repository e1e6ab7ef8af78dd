with Ada.Characters.Latin_1;
with Ada.Command_Line;
with Ada.Directories;
with Ada.Environment_Variables;
with Ada.Streams;             use Ada.Streams;
with Ada.Strings.Fixed;       use Ada.Strings, Ada.Strings.Fixed;
with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;
with Ada.Unchecked_Conversion;
with GNAT.OS_Lib;             use GNAT, GNAT.OS_Lib;
with GNAT.Sockets;            use GNAT.Sockets;
with Interfaces;              use Interfaces;

with Sim.Complaints;          use Sim.Complaints;
with Sim.Names;               use Sim.Names;
with Sim.Scaling;             use Sim.Scaling;

package body Sim.JSBSim is

   Interpreter_Variable : constant String := "URV_PYTHON";
   Interpreter_Path     : constant String := "/../.venv/bin/python";
   Script_Path          : constant String := "/../sim/jsbsim/plant.py";
   Remedy               : constant String := "; `make fly` sets it up";

   --  The C library computes sines with fused multiply-add where the
   --  processor has it, and the last bit differs. Without it every processor
   --  gives the same flight.
   Library_Variable : constant String := "GLIBC_TUNABLES";
   Library_Setting  : constant String := "glibc.cpu.hwcaps=-FMA,-FMA4";

   --  The first answer takes half a second, or several on a machine that
   --  has to read Python and JSBSim from its disk.
   Longest_Wait : constant Duration := 60.0;

   --  At the end the other process has this long before it is killed.
   Ending_Polls : constant := 300;
   Ending_Poll  : constant Duration := 0.01;

   Line_Feed : constant Character := Ada.Characters.Latin_1.LF;

   --  The fields of Flight_State, in order.
   type Truth_Item is
     (Altitude, Airspeed, Bank, Pitch, Heading, Climb, Crashed);

   Truth_Names : constant String :=
     "truth,altitude,ft" & Line_Feed
     & "truth,airspeed,kt" & Line_Feed
     & "truth,bank,deg" & Line_Feed
     & "truth,pitch,deg" & Line_Feed
     & "truth,heading,deg" & Line_Feed
     & "truth,climb,ft/s" & Line_Feed
     & "truth,crashed,yes" & Line_Feed;

   --  A number on the connection is a big-endian IEEE double.
   Bytes_Per_Number : constant := 8;

   Servo_Count  : constant := Servo_Item'Pos (Servo_Item'Last) + 1;
   Sensor_Count : constant := Sensor_Item'Pos (Sensor_Item'Last) + 1;
   Truth_Count  : constant := Truth_Item'Pos (Truth_Item'Last) + 1;

   subtype Command_Message is
     Stream_Element_Array (1 .. Servo_Count * Bytes_Per_Number);
   subtype State_Message is
     Stream_Element_Array
       (1 .. (Sensor_Count + Truth_Count) * Bytes_Per_Number);

   function To_Bits is new Ada.Unchecked_Conversion (Long_Float, Unsigned_64);
   function To_Number is
     new Ada.Unchecked_Conversion (Unsigned_64, Long_Float);

   Link    : Socket_Type := No_Socket;
   Process : Process_Id  := Invalid_Pid;

   --  The directory of the running program, links followed.
   function Program_Directory return String;

   function Interpreter (Home : String) return String;

   procedure Put
     (Message : in out Stream_Element_Array;
      Last    : in out Stream_Element_Offset;
      Value   : Long_Float);

   procedure Get
     (Message : Stream_Element_Array;
      Last    : in out Stream_Element_Offset;
      Value   : out Long_Float);

   procedure Send (Message : Stream_Element_Array);

   --  Waits for the whole message.
   procedure Receive (Message : out Stream_Element_Array);

   function Received_Line return String;

   procedure Receive_State
     (Sensors : out Sensor_Words;
      Truth   : out Flight_State);

   --  The names and units of all numbers to be sent and received.
   function Introduction return Stream_Element_Array;

   procedure Spawn_Plant;

   function Program_Directory return String is
      Command : constant String := Ada.Command_Line.Command_Name;
      Found   : OS_Lib.String_Access   := Locate_Exec_On_Path (Command);
      Path    : constant String :=
        Normalize_Pathname (if Found = null then Command else Found.all);
   begin
      Free (Found);
      return Ada.Directories.Containing_Directory (Path);
   end Program_Directory;

   function Interpreter (Home : String) return String is
   begin
      if not Ada.Environment_Variables.Exists (Interpreter_Variable) then
         return Home & Interpreter_Path;
      end if;

      declare
         Named : constant String :=
           Ada.Environment_Variables.Value (Interpreter_Variable);
         Found : OS_Lib.String_Access := Locate_Exec_On_Path (Named);
         Path  : constant String :=
           (if Found = null then Named else Found.all);
      begin
         Free (Found);
         return Path;
      end;
   end Interpreter;

   procedure Put
     (Message : in out Stream_Element_Array;
      Last    : in out Stream_Element_Offset;
      Value   : Long_Float)
   is
      Bits : Unsigned_64 := To_Bits (Value);
   begin
      for Index in reverse Last + 1 .. Last + Bytes_Per_Number loop
         Message (Index) := Stream_Element (Bits and 16#FF#);
         Bits := Shift_Right (Bits, 8);
      end loop;
      Last := Last + Bytes_Per_Number;
   end Put;

   procedure Get
     (Message : Stream_Element_Array;
      Last    : in out Stream_Element_Offset;
      Value   : out Long_Float)
   is
      Bits : Unsigned_64 := 0;
   begin
      for Index in Last + 1 .. Last + Bytes_Per_Number loop
         Bits := Shift_Left (Bits, 8) or Unsigned_64 (Message (Index));
      end loop;
      Last  := Last + Bytes_Per_Number;
      Value := To_Number (Bits);
   end Get;

   procedure Send (Message : Stream_Element_Array) is
      Last : Stream_Element_Offset := Message'First - 1;
   begin
      while Last < Message'Last loop
         Send_Socket (Link, Message (Last + 1 .. Message'Last), Last);
      end loop;
   exception
      when Socket_Error =>
         raise Plant_Failure with "JSBSim's process has ended";
   end Send;

   procedure Receive (Message : out Stream_Element_Array) is
      Last : Stream_Element_Offset := Message'First - 1;
      Next : Stream_Element_Offset;
   begin
      while Last < Message'Last loop
         Next := Last + 1;
         Receive_Socket (Link, Message (Next .. Message'Last), Last);
         if Last < Next then
            raise Plant_Failure with "JSBSim's process has ended";
         end if;
      end loop;
   exception
      when Socket_Error =>
         raise Plant_Failure with "JSBSim's process does not answer";
   end Receive;

   function Received_Line return String is
      Line : Unbounded_String;
      Next : Stream_Element_Array (1 .. 1);
   begin
      loop
         Receive (Next);
         exit when Character'Val (Next (1)) = Line_Feed;
         Append (Line, Character'Val (Next (1)));
      end loop;
      return To_String (Line);
   end Received_Line;

   procedure Receive_State
     (Sensors : out Sensor_Words;
      Truth   : out Flight_State)
   is
      Message : State_Message;
      Last    : Stream_Element_Offset := 0;
      Value   : Long_Float;
      Numbers : array (Truth_Item) of Long_Float;
   begin
      Receive (Message);
      for Item in Sensor_Item loop
         Get (Message, Last, Value);
         Sensors (Item) := To_Word (Value, Scaling.Sensors (Item));
      end loop;
      for Number of Numbers loop
         Get (Message, Last, Number);
      end loop;
      Truth :=
        (Altitude => Numbers (Altitude),
         Airspeed => Numbers (Airspeed),
         Bank     => Numbers (Bank),
         Pitch    => Numbers (Pitch),
         Heading  => Numbers (Heading),
         Climb    => Numbers (Climb),
         Crashed  => Numbers (Crashed) /= 0.0);
   end Receive_State;

   function Introduction return Stream_Element_Array is
      Text : Unbounded_String;
   begin
      for Item in Servo_Item loop
         Append
           (Text,
            "servo," & Name (Item) & ','
            & Symbol (Servos (Item).Measured_In) & Line_Feed);
      end loop;
      for Item in Sensor_Item loop
         Append
           (Text,
            "sensor," & Name (Item) & ','
            & Symbol (Sensors (Item).Measured_In) & Line_Feed);
      end loop;
      Append (Text, Truth_Names & Line_Feed);

      return Bytes : Stream_Element_Array
        (1 .. Stream_Element_Offset (Length (Text)))
      do
         for Index in Bytes'Range loop
            Bytes (Index) :=
              Character'Pos (Element (Text, Positive (Index)));
         end loop;
      end return;
   end Introduction;

   procedure Spawn_Plant is
      Home   : constant String := Program_Directory;
      Python : constant String := Interpreter (Home);
      Script : constant String := Normalize_Pathname (Home & Script_Path);
      Theirs : Socket_Type;
      Closed : Boolean;
   begin
      if not Is_Executable_File (Python) then
         Refuse ("--plant jsbsim: no Python at " & Python & Remedy);
      elsif not Is_Regular_File (Script) then
         Refuse ("--plant jsbsim: no file " & Script);
      end if;

      --  The process inherits its end of the connection and not ours: so
      --  each side sees when the other one has ended.
      Create_Socket_Pair (Link, Theirs);
      Set_Close_On_Exec (Link, True, Closed);
      pragma Assert (Closed);
      Set_Close_On_Exec (Theirs, False, Closed);
      pragma Assert (Closed);
      Set_Socket_Option
        (Link, Socket_Level, (Receive_Timeout, Timeout => Longest_Wait));

      Ada.Environment_Variables.Set (Library_Variable, Library_Setting);
      declare
         Arguments : Argument_List :=
           (new String'(Script),
            new String'(Trim (Image (Theirs), Left)));
      begin
         Process := Non_Blocking_Spawn (Python, Arguments);
         for Argument of Arguments loop
            Free (Argument);
         end loop;
      end;
      Close_Socket (Theirs);
      if Process = Invalid_Pid then
         Refuse ("--plant jsbsim: cannot run " & Python & Remedy);
      end if;
   end Spawn_Plant;

   procedure Start (Sensors : out Sensor_Words; Truth : out Flight_State) is
      Ready : constant String := "ready";
   begin
      Stop;
      Spawn_Plant;
      Send (Introduction);
      declare
         Answer : constant String := Received_Line;
      begin
         if Answer /= Ready then
            Stop;
            Refuse ("--plant jsbsim: " & Answer & Remedy);
         end if;
      end;
      Receive_State (Sensors, Truth);
   exception
      when Plant_Failure =>
         Stop;
         Refuse ("--plant jsbsim: plant.py has failed" & Remedy);
   end Start;

   procedure Step
     (Servos  : PWM_Buffer;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State)
   is
      Message : Command_Message;
      Last    : Stream_Element_Offset := 0;
   begin
      for Item in Servo_Item loop
         Put
           (Message, Last, To_Unit (Servos (Item), Scaling.Servos (Item)));
      end loop;
      Send (Message);
      Receive_State (Sensors, Truth);
   end Step;

   procedure Stop is
      Ended   : Process_Id := Invalid_Pid;
      Success : Boolean;
   begin
      if Link /= No_Socket then
         Close_Socket (Link);
         Link := No_Socket;
      end if;
      if Process = Invalid_Pid then
         return;
      end if;

      for Poll in 1 .. Ending_Polls loop
         Non_Blocking_Wait_Process (Ended, Success);
         exit when Ended = Process;
         delay Ending_Poll;
      end loop;
      if Ended /= Process then
         Kill (Process);
         Wait_Process (Ended, Success);
      end if;
      Process := Invalid_Pid;
   end Stop;

end Sim.JSBSim;
