--  SPDX-License-Identifier: Apache-2.0

--  A simulated serial port. Before each access come the events of
--  Simulated_Line.

with Simulated_Line;

package body STM32_USART.Registers with SPARK_Mode => Off is

   Port_States : array (Port_Name) of Port_Model :=
     (others =>
        (Settings                                => (others => False),
         More_Settings                           => (Stop => One),
         Bit_Time                                => 0,
         Present | Losses | Overrun_Resets | Sent => 0,
         Last_Sent                               => 0,
         Takes_Character                         => True,
         others                                  => False));

   --  All received characters, by number modulo 256.
   All_Received : array (Port_Name, Event_Number range 0 .. 255) of
     Heard_Character;

   procedure Advance (Port : Port_Name);

   procedure Advance (Port : Port_Name) is
      This   : Port_Model renames Port_States (Port);
      Events : Simulated_Line.Event_Count;
      Item   : Simulated_Line.Sent_Character;
   begin
      Simulated_Line.Begin_Access (Events);
      for Number in 1 .. Events loop
         Simulated_Line.Arrive (Item);
         if not This.Settings.Receiver_On then
            null;
         elsif This.Received then
            This.Losses := This.Losses + 1;
            This.Overrun := True;
         else
            This.Received := True;
            All_Received (Port, This.Present mod 256) :=
              (Data          => Item.Data,
               Wrong_Parity  => Item.Wrong_Parity,
               Wrong_Framing => Item.Wrong_Framing,
               Noise         => Item.Data mod 2 = 1);
         end if;
      end loop;
      if Events > 0 then
         This.Takes_Character := True;
      end if;
   end Advance;

   function State (Port : Port_Name) return Port_Model is
     (Port_States (Port));

   function Received_Character
     (Port   : Port_Name;
      Number : Event_Number) return Heard_Character
   is
     (All_Received (Port, Number mod 256));

   procedure Write_Control_1 (Port : Port_Name; Value : Control_1) is
   begin
      Advance (Port);
      Port_States (Port).Settings := Value;
   end Write_Control_1;

   procedure Write_Control_2 (Port : Port_Name; Value : Control_2) is
   begin
      Advance (Port);
      Port_States (Port).More_Settings := Value;
   end Write_Control_2;

   procedure Write_Divider (Port : Port_Name; Value : Divider) is
   begin
      Advance (Port);
      Port_States (Port).Bit_Time := Value;
   end Write_Divider;

   procedure Read_Status (Port : Port_Name; Status : out Port_Status) is
      This    : Port_Model renames Port_States (Port);
      Present : Heard_Character;
   begin
      Advance (Port);
      if This.Received then
         Present := All_Received (Port, This.Present mod 256);
      end if;
      This.Overrun_Shown := This.Overrun;
      This.Parity_Shown := Present.Wrong_Parity;
      Status :=
        (Wrong_Parity    => Present.Wrong_Parity,
         Wrong_Framing   => Present.Wrong_Framing,
         Noise           => Present.Noise,
         Overrun         => This.Overrun,
         Is_Silent       => not This.Received,
         Received        => This.Received,
         Is_Complete     => This.Takes_Character,
         Takes_Character => This.Takes_Character);
   end Read_Status;

   procedure Read_Data (Port : Port_Name; Data : out Byte) is
      This : Port_Model renames Port_States (Port);
   begin
      Advance (Port);
      Data := 0;
      if This.Received then
         Data := All_Received (Port, This.Present mod 256).Data;
         This.Present := This.Present + 1;
         This.Received := False;
      end if;
      This.Parity_Shown := False;
      if This.Overrun_Shown then
         This.Overrun := False;
         This.Overrun_Shown := False;
         This.Overrun_Resets := This.Overrun_Resets + 1;
      end if;
   end Read_Data;

   procedure Write_Data (Port : Port_Name; Data : Byte) is
   begin
      Advance (Port);
      Port_States (Port) := With_Character (Port_States (Port), Data);
   end Write_Data;

end STM32_USART.Registers;
