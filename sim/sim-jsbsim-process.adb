--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Latin_1;
with Ada.Command_Line;
with Ada.Directories;
with Ada.Environment_Variables;
with Ada.Strings.Fixed;     use Ada.Strings, Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;           use GNAT, GNAT.OS_Lib;
with GNAT.Sockets;          use GNAT.Sockets;

with Host.Complaints;
with Sim.Signals;

package body Sim.JSBSim.Process is

   Interpreter_Variable : constant String := "URV_PYTHON";
   Interpreter_Path     : constant String := "/.venv/bin/python";
   Script_Path          : constant String := "/sim/jsbsim/plant.py";

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

   Link    : Socket_Type := No_Socket;
   Running : Process_Id  := Invalid_Pid;

   --  The directory above that of the running program, links followed.
   function Project_Directory return String;

   function Interpreter (Home : String) return String;

   function Project_Directory return String is
      Command : constant String := Ada.Command_Line.Command_Name;
      Found   : OS_Lib.String_Access := Locate_Exec_On_Path (Command);
      Path    : constant String :=
        Normalize_Pathname (if Found = null then Command else Found.all);
   begin
      Free (Found);
      return
        Ada.Directories.Containing_Directory
          (Ada.Directories.Containing_Directory (Path));
   end Project_Directory;

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

   procedure Spawn is
      Home   : constant String := Project_Directory;
      Python : constant String := Interpreter (Home);
      Script : constant String := Home & Script_Path;
      Theirs : Socket_Type;
      Closed : Boolean;
   begin
      if not Is_Executable_File (Python) then
         Give_Up ("no Python at " & Python);
      elsif not Is_Regular_File (Script) then
         Give_Up ("no file " & Script);
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
         Signals.Begin_Deafness;
         Running := Non_Blocking_Spawn (Python, Arguments);
         Signals.End_Deafness;
         for Argument of Arguments loop
            Free (Argument);
         end loop;
      end;
      Close_Socket (Theirs);
      if Running = Invalid_Pid then
         Give_Up ("cannot run " & Python);
      end if;
   end Spawn;

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

      --  What has come, up to the end of the message. A signal interrupts
      --  a wait that has a time limit; it is waited for anew.
      procedure Receive_Some (First : Stream_Element_Offset);

      procedure Receive_Some (First : Stream_Element_Offset) is
      begin
         loop
            begin
               Receive_Socket (Link, Message (First .. Message'Last), Last);
               return;
            exception
               when Error : Socket_Error =>
                  if Resolve_Exception (Error) /= Interrupted_System_Call
                  then
                     raise;
                  end if;
            end;
         end loop;
      end Receive_Some;

   begin
      while Last < Message'Last loop
         Next := Last + 1;
         Receive_Some (Next);
         if Last < Next then
            raise Plant_Failure with "JSBSim's process has ended";
         end if;
      end loop;
   exception
      when Socket_Error =>
         raise Plant_Failure with "JSBSim's process is dead or mute";
   end Receive;

   function Received_Line return String is
      Line : Unbounded_String;
      Next : Stream_Element_Array (1 .. 1);
   begin
      loop
         Receive (Next);
         exit when Character'Val (Next (1)) = Ada.Characters.Latin_1.LF;
         Append (Line, Character'Val (Next (1)));
      end loop;
      return To_String (Line);
   end Received_Line;

   procedure Stop is
      Ended   : Process_Id := Invalid_Pid;
      Success : Boolean;
   begin
      if Link /= No_Socket then
         Close_Socket (Link);
         Link := No_Socket;
      end if;
      if Running = Invalid_Pid then
         return;
      end if;

      for Poll in 1 .. Ending_Polls loop
         Non_Blocking_Wait_Process (Ended, Success);
         exit when Ended = Running;
         delay Ending_Poll;
      end loop;
      if Ended /= Running then
         Kill (Running);
         Wait_Process (Ended, Success);
      end if;
      Running := Invalid_Pid;
   end Stop;

   procedure Give_Up (Why : String) is
   begin
      Stop;
      Complaints.Refuse
        ("--plant jsbsim: " & Why & "; `make fly` sets it up");
   end Give_Up;

end Sim.JSBSim.Process;
