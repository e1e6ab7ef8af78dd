with Ada.Exceptions;
with Ada.Text_IO;

with Devices.PWM_Board;
with GSC.Virtual_Time;
with MCS.Virtual_Time;
with Memory_Hardware;
with URV.PWM_Layout;

package body Sim.Nodes is

   package Ground renames Standard.GSC;
   package Aircraft renames Standard.MCS;
   package GSC_Time renames Ground.Virtual_Time;
   package MCS_Time renames Aircraft.Virtual_Time;

   Failed : Boolean := False;

   --  Says that a node's program has failed, the first time.
   procedure Complain
     (Which : Node; Error : Ada.Exceptions.Exception_Occurrence);

   function Memory_Of (Which : Node) return Devices.Memory_Bus.Board_Number is
     (case Which is
         when GSC => 1,
         when MCS => 2);

   function Has_Failed return Boolean is (Failed);

   procedure Complain
     (Which : Node; Error : Ada.Exceptions.Exception_Occurrence) is
   begin
      if not Failed then
         Failed := True;
         Ada.Text_IO.Put_Line
           (Ada.Text_IO.Standard_Error,
            "urv_sim: internal fault: " & Which'Image
            & " restarts its processor: "
            & Ada.Exceptions.Exception_Information (Error));
      end if;
   end Complain;

   procedure Start
     (Which      : Node;
      Condition  : Start_Condition;
      Now        : URVOS.Frames.Clock_Tick;
      Processors : Processor_Count;
      Raised     : out Boolean) is
   begin
      Raised := False;
      if Condition = Cold_Start then
         Restart_Telemetry (Which);
      end if;
      case Which is
         when GSC =>
            GSC_Time.Start (Condition, Now);
         when MCS =>
            MCS_Time.Start
              (Condition, Now, Aircraft.Processor_Number (Processors));
      end case;
   exception
      when Memory_Hardware.Bus_Error =>
         Raised := True;
      when Error : others =>
         Raised := True;
         Complain (Which, Error);
   end Start;

   procedure Restart_Telemetry (Which : Node) is
   begin
      case Which is
         when GSC => Ground.Telemetry_Board.Start;
         when MCS => Aircraft.Telemetry_Board.Start;
      end case;
   end Restart_Telemetry;

   procedure Clock_Interrupt
     (Which  : Node;
      Now    : URVOS.Frames.Clock_Tick;
      Raised : out Boolean) is
   begin
      Raised := False;
      case Which is
         when GSC => GSC_Time.Clock_Interrupt (Now);
         when MCS => MCS_Time.Clock_Interrupt (Now);
      end case;
   exception
      when Memory_Hardware.Bus_Error =>
         Raised := True;
      when Error : others =>
         Raised := True;
         Complain (Which, Error);
   end Clock_Interrupt;

   procedure Take_Start
     (Which   : Node;
      Wanted  : out Boolean;
      Channel : out Devices.AD_Board.Channel_Number)
   is
   begin
      case Which is
         when GSC => Ground.AD_Board.Take_Start (Wanted, Channel);
         when MCS => Aircraft.AD_Board.Take_Start (Wanted, Channel);
      end case;
   end Take_Start;

   procedure Finish_Conversion
     (Which  : Node;
      Value  : Word;
      Is_Up  : Boolean;
      Raised : out Boolean)
   is
      Interrupt : Boolean;
   begin
      Raised := False;
      case Which is
         when GSC =>
            Ground.AD_Board.Finish (Value, Interrupt);
            if Interrupt and then Is_Up then
               Ground.AD_Interrupt;
            end if;
         when MCS =>
            Aircraft.AD_Board.Finish (Value, Interrupt);
            if Interrupt and then Is_Up then
               Aircraft.AD_Interrupt;
            end if;
      end case;
   exception
      when Error : others =>
         Raised := True;
         Complain (Which, Error);
   end Finish_Conversion;

   procedure Accept_Character
     (Which        : Node;
      Elapsed      : Telemetry.Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      May_Speak    : out Boolean)
   is
   begin
      case Which is
         when GSC =>
            Ground.Telemetry_Board.Accept_Character
              (Elapsed, Data, Parity_Error, May_Speak);
         when MCS =>
            Aircraft.Telemetry_Board.Accept_Character
              (Elapsed, Data, Parity_Error, May_Speak);
      end case;
   end Accept_Character;

   procedure Next_Character
     (Which     : Node;
      Elapsed   : Telemetry.Character_Times;
      Send      : out Boolean;
      Data      : out Byte;
      Time_Left : out Telemetry.Character_Times)
   is
   begin
      case Which is
         when GSC =>
            Ground.Telemetry_Board.Next_Character
              (Elapsed, Send, Data, Time_Left);
         when MCS =>
            Aircraft.Telemetry_Board.Next_Character
              (Elapsed, Send, Data, Time_Left);
      end case;
   end Next_Character;

   function Servos return PWM_Buffer is
      Area : Devices.PWM_Board.Data_Area;
   begin
      Aircraft.PWM_Board.Read (Area);
      return URV.PWM_Layout.To_Outputs (Area);
   end Servos;

   function CORE (Which : Node) return Devices.CORE_Memory.Memory is
      Snapshot : Devices.CORE_Memory.Memory;
   begin
      case Which is
         when GSC => Ground.CORE_Memory.Inspect (Snapshot);
         when MCS => Aircraft.CORE_Memory.Inspect (Snapshot);
      end case;
      return Snapshot;
   end CORE;

   function Tally (Which : Node) return Telemetry.Boards.Statistics is
      Snapshot : Telemetry.Boards.Statistics;
   begin
      case Which is
         when GSC => Ground.Telemetry_Board.Inspect (Snapshot);
         when MCS => Aircraft.Telemetry_Board.Inspect (Snapshot);
      end case;
      return Snapshot;
   end Tally;

   function Errors (Which : Node) return URV.Errors.Error_Log is
      Snapshot : URV.Errors.Error_Log;
   begin
      case Which is
         when GSC => Ground.Errors.Inspect (Snapshot);
         when MCS => Aircraft.Errors.Inspect (Snapshot);
      end case;
      return Snapshot;
   end Errors;

   function Overruns (Which : Node) return Count is
     (case Which is
         when GSC => GSC_Time.Overruns,
         when MCS => MCS_Time.Overruns);

end Sim.Nodes;
