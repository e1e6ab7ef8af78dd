--  SPDX-License-Identifier: Apache-2.0

--  A simulated MC68681. Before each access come the events of Simulated_Line.

with Simulated_Line;

package body MC68681.Registers with SPARK_Mode => Off is

   --  The channel's receiver beside its model: the character in the shift
   --  register, and all that were received, by number modulo 256.

   type Received_Characters is array (Event_Number range 0 .. 255) of
     Heard_Character;

   type Receiver is record
      Shift_Is_Full : Boolean := False;
      Shift         : Heard_Character;
      Received      : Received_Characters;
   end record;

   Port_States : array (Port_Name) of Port_Model :=
     (others =>
        (First_Mode | Second_Mode => <>,
         Oldest | Losses | Overrun_Resets | Sent => 0,
         Held                                    => 0,
         Clocks | Last_Sent                      => 0,
         others                                  => False));

   Receivers : array (Port_Name) of Receiver;

   Chip_States : array (Chip_Name) of Chip_Model :=
     (others =>
        (Interrupts           => (others => False),
         Vector | Auxiliary   => 0,
         High | Low           => 0,
         Periods | Due_Resets => 0,
         Runs | Is_Due        => False));

   procedure Advance (Port : Port_Name);

   procedure Advance (Chip : Chip_Name);

   procedure Hear (Port : in out Port_Model; Side : in out Receiver);

   --  The character in the shift register comes into the FIFO.
   procedure Settle (Port : in out Port_Model; Side : in out Receiver);

   procedure Settle (Port : in out Port_Model; Side : in out Receiver) is
   begin
      if Side.Shift_Is_Full and then Port.Held < Receiver_Places then
         Side.Received ((Port.Oldest + Event_Number (Port.Held)) mod 256) :=
           Side.Shift;
         Port.Held := Port.Held + 1;
         Side.Shift_Is_Full := False;
      end if;
   end Settle;

   procedure Hear (Port : in out Port_Model; Side : in out Receiver) is
      Item : Simulated_Line.Sent_Character;
   begin
      Simulated_Line.Arrive (Item);
      if not Port.Receiver_Is_On then
         return;
      end if;
      if Side.Shift_Is_Full then
         Port.Losses := Port.Losses + 1;
         Port.Overrun := True;
      end if;
      Side.Shift_Is_Full := True;
      Side.Shift :=
        (Data          => Item.Data,
         Wrong_Parity  => Item.Wrong_Parity,
         Wrong_Framing => Item.Wrong_Framing,
         Is_Break      => Item.Wrong_Framing and then Item.Data = 0);
      Settle (Port, Side);
   end Hear;

   procedure Advance (Port : Port_Name) is
      Events : Simulated_Line.Event_Count;
   begin
      Simulated_Line.Begin_Access (Events);
      for Number in 1 .. Events loop
         Hear (Port_States (Port), Receivers (Port));
      end loop;
      if Port_States (Port).Sender_Is_On and then Events > 0 then
         Port_States (Port).Takes_Character := True;
      end if;
   end Advance;

   procedure Advance (Chip : Chip_Name) is
      This   : Chip_Model renames Chip_States (Chip);
      Events : Simulated_Line.Event_Count;
   begin
      Simulated_Line.Begin_Access (Events);
      if This.Runs and then Events > 0 then
         This.Periods := This.Periods + Event_Number (Events);
         This.Is_Due := True;
      end if;
   end Advance;

   function State (Port : Port_Name) return Port_Model is
     (Port_States (Port));

   function State (Chip : Chip_Name) return Chip_Model is
     (Chip_States (Chip));

   function Received_Character
     (Port   : Port_Name;
      Number : Event_Number) return Heard_Character
   is
     (Receivers (Port).Received (Number mod 256));

   procedure Write_Mode (Port : Port_Name; Mode : Mode_1) is
   begin
      Advance (Port);
      Port_States (Port) := With_Mode (Port_States (Port), Mode);
   end Write_Mode;

   procedure Write_Mode (Port : Port_Name; Mode : Mode_2) is
   begin
      Advance (Port);
      Port_States (Port) := With_Mode (Port_States (Port), Mode);
   end Write_Mode;

   procedure Write_Clocks (Port : Port_Name; Clocks : Byte) is
   begin
      Advance (Port);
      Port_States (Port).Clocks := Clocks;
   end Write_Clocks;

   procedure Write_Command (Port : Port_Name; Order : Command) is
      This : Port_Model renames Port_States (Port);
   begin
      Advance (Port);
      case Order is
         when Switch_On_Sender =>
            This.Sender_Is_On := True;
         when Switch_On_Both =>
            This.Receiver_Is_On := True;
            This.Sender_Is_On := True;
         when Reset_Mode_Pointer =>
            This.Second_Is_Next := False;
         when Reset_Receiver =>
            This.Receiver_Is_On := False;
            This.Held := 0;
            This.Errors_Are_Gone := False;
            Receivers (Port).Shift_Is_Full := False;
         when Reset_Sender =>
            This.Sender_Is_On := False;
            This.Takes_Character := False;
         when Reset_Errors =>
            if This.Overrun then
               This.Overrun := False;
               This.Overrun_Resets := This.Overrun_Resets + 1;
            end if;
            This.Errors_Are_Gone := This.Held > 0;
      end case;
   end Write_Command;

   procedure Read_Status (Port : Port_Name; Status : out Channel_Status) is
      This   : Port_Model renames Port_States (Port);
      Oldest : Heard_Character;
   begin
      Advance (Port);
      if This.Held > 0 and then not This.Errors_Are_Gone then
         Oldest := Receivers (Port).Received (This.Oldest mod 256);
      end if;
      Status :=
        (Received        => This.Held > 0,
         Is_Full         => This.Held = Receiver_Places,
         Takes_Character => This.Takes_Character,
         Is_Empty        => This.Takes_Character,
         Errors          =>
           (if This.Overrun then Overrun else No_Errors)
           or (if Oldest.Wrong_Parity then Wrong_Parity else No_Errors)
           or (if Oldest.Wrong_Framing then Wrong_Framing else No_Errors)
           or (if Oldest.Is_Break then Is_Break else No_Errors));
   end Read_Status;

   procedure Read_Data (Port : Port_Name; Data : out Byte) is
      This : Port_Model renames Port_States (Port);
   begin
      Advance (Port);
      Data := Receivers (Port).Received (This.Oldest mod 256).Data;
      This := Without_Oldest (This);
      Settle (This, Receivers (Port));
   end Read_Data;

   procedure Write_Data (Port : Port_Name; Data : Byte) is
   begin
      Advance (Port);
      Port_States (Port) := With_Character (Port_States (Port), Data);
   end Write_Data;

   procedure Write_Auxiliary (Chip : Chip_Name; Value : Byte) is
   begin
      Advance (Chip);
      Chip_States (Chip).Auxiliary := Value;
   end Write_Auxiliary;

   procedure Write_Count_High (Chip : Chip_Name; Value : Count_Half) is
   begin
      Advance (Chip);
      Chip_States (Chip).High := Value;
   end Write_Count_High;

   procedure Write_Count_Low (Chip : Chip_Name; Value : Count_Half) is
   begin
      Advance (Chip);
      Chip_States (Chip).Low := Value;
   end Write_Count_Low;

   procedure Start_Timer (Chip : Chip_Name) is
   begin
      Advance (Chip);
      Chip_States (Chip).Runs := True;
   end Start_Timer;

   procedure Answer_Timer (Chip : Chip_Name) is
      This : Chip_Model renames Chip_States (Chip);
   begin
      Advance (Chip);
      if This.Is_Due then
         This.Is_Due := False;
         This.Due_Resets := This.Due_Resets + 1;
      end if;
   end Answer_Timer;

   procedure Read_Interrupts (Chip : Chip_Name; Pending : out Interrupt_Set)
   is
   begin
      Advance (Chip);
      Pending :=
        (Timer      => Chip_States (Chip).Is_Due,
         Receiver_A => Chip = Line_Chip and then Port_States (Line).Held > 0,
         others     => False);
   end Read_Interrupts;

   procedure Write_Interrupts (Chip : Chip_Name; Used : Interrupt_Set) is
   begin
      Advance (Chip);
      Chip_States (Chip).Interrupts := Used;
   end Write_Interrupts;

   procedure Write_Vector (Chip : Chip_Name; Vector : Byte) is
   begin
      Advance (Chip);
      Chip_States (Chip).Vector := Vector;
   end Write_Vector;

end MC68681.Registers;
