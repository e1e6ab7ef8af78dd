--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Exceptions;

with GSC.Virtual_Time;
with Host.Complaints;
with Host.Memory_Hardware;
with Host.Names;
with MCS.Virtual_Time;
with URVOS.Usual_Frames;
with URV.PWM_Layout;
with URV.Surface_Monitor;

package body Sim.Nodes is

   package GSC_Time renames GSC.Virtual_Time;
   package MCS_Time renames MCS.Virtual_Time;

   Failed : Boolean := False;

   --  Reports that a node's program has failed, the first time. A planted bus
   --  error is not reported.
   procedure Complain
     (Which : Node; Error : Ada.Exceptions.Exception_Occurrence);

   function Memory_Of (Which : Node) return Devices.Memory_Bus.Board_Number is
     (case Which is
         when Ground   => 1,
         when Aircraft => 2);

   function Has_Failed return Boolean is (Failed);

   procedure Complain
     (Which : Node; Error : Ada.Exceptions.Exception_Occurrence)
   is
      use type Ada.Exceptions.Exception_Id;
   begin
      if not Failed
        and then Ada.Exceptions.Exception_Identity (Error) /=
                   Host.Memory_Hardware.Bus_Error'Identity
      then
         Failed := True;
         Host.Complaints.Report
           ("internal fault: "
            & To_Upper (Host.Names.Name (Which))
            & " restarts its processor: "
            & Ada.Exceptions.Exception_Information (Error));
      end if;
   end Complain;

   procedure Seal_Link
     (Format : URV.Handshakes.Format_Number;
      Keys   : URV.Sessions.Key_List;
      Start  : URV.Seal_Blocks.Nonce)
   is
      use type URV.Seal_Blocks.Nonce;
   begin
      GSC.Sealing.Configure (Format, Keys, Start);
      MCS.Sealing.Configure (Format, Keys, not Start);
   end Seal_Link;

   procedure Start
     (Which      : Node;
      Condition  : Start_Condition;
      Now        : URVOS.Frames.Clock_Tick;
      Processors : Processor_Count;
      Raised     : out Boolean)
   is
   begin
      Raised := False;
      if Condition = Cold_Start then
         Restart_Telemetry (Which);
      end if;
      case Which is
         when Ground   =>
            GSC_Time.Start
              (Condition, Now, Processors, GSC.Schedule.Contents);
         when Aircraft =>
            MCS_Time.Start
              (Condition, Now, Processors, MCS.Schedule.Contents);
      end case;
   exception
      when Error : others =>
         Raised := True;
         Complain (Which, Error);
   end Start;

   procedure Set_Schedule (Schedule : Schedule_Name) is
   begin
      GSC.Schedule.Write (Schedule);
      MCS.Schedule.Write (Schedule);
   end Set_Schedule;

   procedure Set_Lock (On : Boolean) is
   begin
      MCS.Frame_Lock.Set (On);
   end Set_Lock;

   procedure Set_Line (Item : Telemetry.Line_Delay) is
   begin
      GSC.Telemetry_Board.Set_Round_Trip (Telemetry.Round_Trip_Of (Item));
      MCS.Telemetry_Board.Set_Round_Trip (Telemetry.Round_Trip_Of (Item));
   end Set_Line;

   procedure Look_At_Frame
     (Which   : Node;
      Ticks   : URVOS.Frame_Clocks.Tick_Count;
      Request : in out URVOS.Frame_Clocks.Frame_Request) is
   begin
      case Which is
         when Ground   => URVOS.Usual_Frames (Ticks, Request);
         when Aircraft => MCS.Look_At_Frame (Ticks, Request);
      end case;
   end Look_At_Frame;

   function Lock return URVOS.Frame_Locks.Lock_State is
     (MCS.Frame_Lock.Contents);

   procedure Set_Laws (On : Boolean; By : URV.Link_Loss.Times) is
      Set : URV.Laws.Settings := MCS.Law_Settings.Contents;
   begin
      Set.On := On;
      Set.By := By;
      MCS.Law_Settings.Write (Set);
   end Set_Laws;

   function Failed_Surfaces return Word is
     (URV.Surface_Monitor.Failed_Bits (MCS.Law_Memory.Contents.Watched));

   procedure Set_Recorder (Length : URV.Recorder_Rings.Ring_Length) is
   begin
      MCS.Recorder.Set_Length (Length);
   end Set_Recorder;

   function Recorder return URV.Recorder_Rings.Ring is
     (MCS.Recorder.Contents);

   function Recorded
     (Number : URV.Recorder_Rows.Row_Number) return URV.Recorder_Rows.Row
   is
     (MCS.Recorder.Row_At (Number));

   procedure Take_Recorder_Block
     (Block : out Downlink_Buffer; Found : out Boolean) is
   begin
      GSC.Recorder_Blocks.Look (Block, Found);
   end Take_Recorder_Block;

   procedure Order (Block : Uplink_Buffer) is
      Unused_Success : Boolean;
   begin
      GSC.Console_Orders.Send (Block, Unused_Success);
   end Order;

   function Configured return URV.Configurations.Setting is
     (MCS.Law_Memory.Contents.Set);

   function Cards return URV.Test_Runs.Aboard is
     (MCS.Law_Memory.Contents.Cards);

   function Laws return URV.Laws.Memory is (MCS.Law_Memory.Contents.Flown);

   procedure Restart_Telemetry (Which : Node) is
   begin
      case Which is
         when Ground   => GSC.Telemetry_Board.Start;
         when Aircraft => MCS.Telemetry_Board.Start;
      end case;
   end Restart_Telemetry;

   procedure Clock_Interrupt
     (Which  : Node;
      Now    : URVOS.Frames.Clock_Tick;
      Raised : out Boolean) is
   begin
      Raised := False;
      case Which is
         when Ground   => GSC_Time.Clock_Interrupt (Now);
         when Aircraft => MCS_Time.Clock_Interrupt (Now);
      end case;
   exception
      when Error : others =>
         Raised := True;
         Complain (Which, Error);
   end Clock_Interrupt;

   procedure Look_Again (Which : Node; Raised : out Boolean) is
   begin
      Raised := False;
      case Which is
         when Ground   => GSC_Time.Look_Again;
         when Aircraft => MCS_Time.Look_Again;
      end case;
   exception
      when Error : others =>
         Raised := True;
         Complain (Which, Error);
   end Look_Again;

   procedure Tick_Servos is
   begin
      MCS.PWM_Board.Tick;
   end Tick_Servos;

   procedure Take_Start
     (Which   : Node;
      Wanted  : out Boolean;
      Channel : out Devices.AD_Board.Channel_Number)
   is
   begin
      case Which is
         when Ground   => GSC.AD_Board.Take_Start (Wanted, Channel);
         when Aircraft => MCS.AD_Board.Take_Start (Wanted, Channel);
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
         when Ground =>
            GSC.AD_Board.Finish (Value, Interrupt);
            if Interrupt and then Is_Up then
               GSC.ADINT.Handle_Interrupt;
            end if;
         when Aircraft =>
            MCS.AD_Board.Finish (Value, Interrupt);
            if Interrupt and then Is_Up then
               MCS.ADINT.Handle_Interrupt;
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
         when Ground =>
            GSC.Telemetry_Board.Accept_Character
              (Elapsed, Data, Parity_Error, May_Speak);
         when Aircraft =>
            MCS.Telemetry_Board.Accept_Character
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
         when Ground =>
            GSC.Telemetry_Board.Next_Character
              (Elapsed, Send, Data, Time_Left);
         when Aircraft =>
            MCS.Telemetry_Board.Next_Character
              (Elapsed, Send, Data, Time_Left);
      end case;
   end Next_Character;

   function Servos return PWM_Buffer is
     (URV.PWM_Layout.To_Outputs (MCS.PWM_Board.Contents));

   function CORE (Which : Node) return URV.CORE_Memory.Memory is
     (case Which is
         when Ground   => GSC.CORE_Memory.Contents,
         when Aircraft => MCS.CORE_Memory.Contents);

   function Tally (Which : Node) return Telemetry.Boards.Statistics is
     (case Which is
         when Ground   => GSC.Telemetry_Board.Tally,
         when Aircraft => MCS.Telemetry_Board.Tally);

   function Errors (Which : Node) return URV.Errors.Error_Log is
     (case Which is
         when Ground   => GSC.Errors.Contents,
         when Aircraft => MCS.Errors.Contents);

   function Overruns (Which : Node) return Count is
     (case Which is
         when Ground   => GSC_Time.Overruns,
         when Aircraft => MCS_Time.Overruns);

end Sim.Nodes;
