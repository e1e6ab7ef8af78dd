--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Latin_1;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;           use GNAT, GNAT.OS_Lib;
with GNAT.Sockets;          use GNAT.Sockets;

with Host.Complaints;
with Host.Plant_Program;
with Sim.Signals;

package body Sim.JSBSim.Process is

   --  The first answer takes half a second, or several seconds when Python and
   --  JSBSim must be read from the disk.
   Longest_Wait : constant := 60;

   --  After a second without an answer it is reported (SIM-9).
   Wait         : constant Duration := 1.0;

   Has_Ended : constant String := "JSBSim's process has ended";

   --  At the end the other process has this long before it is killed.
   Ending_Polls : constant := 300;
   Ending_Poll  : constant Duration := 0.01;

   --  The number of polls for an answer before this process sleeps until one
   --  comes: with two processors the aircraft's frame takes less time than a
   --  wake-up. If the other process only runs when this one sleeps, polling
   --  fails, and becomes ever rarer.
   Looks      : constant := 600;
   Most_Skips : constant := 511;

   Skips   : Natural := 0;   --  after the last failed poll
   To_Skip : Natural := 0;

   --  The first answer takes longer.
   Has_Answered : Boolean := False;

   Link    : Socket_Type := No_Socket;
   Running : Process_Id  := Invalid_Pid;

   procedure Spawn is
      Theirs : Socket_Type;
      Closed : Boolean;
   begin
      --  The process inherits only its end of the connection, so that each
      --  side sees when the other one has ended.
      Create_Socket_Pair (Link, Theirs);
      Set_Close_On_Exec (Link, True, Closed);
      pragma Assert (Closed);
      Set_Close_On_Exec (Theirs, False, Closed);
      pragma Assert (Closed);
      Set_Socket_Option
        (Link, Socket_Level, (Receive_Timeout, Timeout => Wait));

      Signals.Begin_Deafness;
      Plant_Program.Spawn (To_C (Theirs), Running);
      Signals.End_Deafness;
      Close_Socket (Theirs);
   end Spawn;

   procedure Send (Message : Stream_Element_Array) is
      Last : Stream_Element_Offset := Message'First - 1;
   begin
      while Last < Message'Last loop
         Send_Socket (Link, Message (Last + 1 .. Message'Last), Last);
      end loop;
   exception
      when Socket_Error =>
         raise Plant_Failure with Has_Ended;
   end Send;

   procedure Look_For (Length : Natural);

   procedure Look_For (Length : Natural) is
      Come : Request_Type (N_Bytes_To_Read);
   begin
      if To_Skip > 0 then
         To_Skip := To_Skip - 1;
         return;
      end if;
      for Look in 1 .. Looks loop
         Control_Socket (Link, Come);
         if Come.Size >= Length then
            Skips := Skips / 2;
            return;
         end if;
      end loop;
      Skips := Natural'Min (2 * Skips + 1, Most_Skips);
      To_Skip := Skips;
   end Look_For;

   function Is_Alone return Boolean is (Skips > 0);

   procedure Receive (Message : out Stream_Element_Array) is
      Last : Stream_Element_Offset := Message'First - 1;
      Next : Stream_Element_Offset;

      --  Receives available bytes, up to the end of the message. A signal
      --  interrupts a wait with a time limit; the wait is then repeated.
      procedure Receive_Some (First : Stream_Element_Offset);

      procedure Receive_Some (First : Stream_Element_Offset) is
         Waits : Natural := 0;
      begin
         loop
            begin
               Receive_Socket (Link, Message (First .. Message'Last), Last);
               if Waits > 0 and then Has_Answered then
                  Host.Complaints.Report
                    ("--plant jsbsim: JSBSim's process answers again");
               end if;
               return;
            exception
               when Error : Socket_Error =>
                  case Resolve_Exception (Error) is
                     when Interrupted_System_Call          => null;
                     when Resource_Temporarily_Unavailable =>
                        Waits := Waits + 1;
                        if Waits = Longest_Wait then
                           raise;
                        elsif Waits = 1 and then Has_Answered then
                           Host.Complaints.Report
                             ("--plant jsbsim: JSBSim's process does not"
                              & " answer: the flight waits");
                        end if;
                     when others                           => raise;
                  end case;
            end;
         end loop;
      end Receive_Some;

   begin
      Look_For (Message'Length);
      while Last < Message'Last loop
         Next := Last + 1;
         Receive_Some (Next);
         if Last < Next then
            raise Plant_Failure with Has_Ended;
         end if;
      end loop;
      Has_Answered := True;
   exception
      when Error : Socket_Error =>
         if Resolve_Exception (Error) = Resource_Temporarily_Unavailable then
            raise Plant_Silence with
              "JSBSim's process has not answered for a minute";
         end if;
         raise Plant_Failure with Has_Ended;
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
      Plant_Program.Refuse (Why);
   end Give_Up;

   procedure Refuse_Flight (Answer : String) is
   begin
      Stop;
      Plant_Program.Refuse_Flight (Answer);
   end Refuse_Flight;

end Sim.JSBSim.Process;
