--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Spare_Bits with SPARK_Mode is

   --  The bits of one word.
   procedure Prove_Word (Value : Converter_Value; Spare : Nibble)
   with
     Global => null,
     Post   =>
       Spare_Of (Value or Spare * Spare_Unit) = Spare
       and then Without_Spare (Value or Spare * Spare_Unit) = Value;

   --  Three words have the parts of a value of 12 bits.
   procedure Prove_Joined (Value : Word; One, Two, Three : Word)
   with
     Global => null,
     Pre    =>
       Value <= Word_Bits
       and then Spare_Of (One) = High (Value)
       and then Spare_Of (Two) = Middle (Value)
       and then Spare_Of (Three) = Low (Value),
     Post   => Joined (One, Two, Three) = Value;

   --  The remainders of two numbers that are less than 4096 apart.
   procedure Prove_Remainders (First, Last : Tick)
   with
     Global => null,
     Pre    => Last - First in 0 .. Frame_Numbers - 1,
     Post   =>
       (Last mod Frame_Numbers - First mod Frame_Numbers)
         mod Frame_Numbers = Last - First;

   procedure Prove_Word (Value : Converter_Value; Spare : Nibble) is null;

   procedure Prove_Joined (Value : Word; One, Two, Three : Word) is null;

   procedure Prove_Remainders (First, Last : Tick) is
      Times_First : constant Tick := First / Frame_Numbers;
      Times_Last  : constant Tick := Last / Frame_Numbers;
      Rest_First  : constant Tick := First mod Frame_Numbers;
      Rest_Last   : constant Tick := Last mod Frame_Numbers;
   begin
      pragma Assert (First = Frame_Numbers * Times_First + Rest_First);
      pragma Assert (Last = Frame_Numbers * Times_Last + Rest_Last);
      pragma Assert (Times_Last in Times_First | Times_First + 1);
      pragma Assert
        (if Rest_Last >= Rest_First
         then Last - First = Rest_Last - Rest_First
         else Last - First = Frame_Numbers + Rest_Last - Rest_First);
   end Prove_Remainders;

   procedure What_Is_Packed_Comes
     (Source : Downlink_Buffer; Frame : Frame_Words)
   is
      Sent : constant Downlink_Buffer := Packed (Source, Frame);
   begin
      for Item in Sensor_Item loop
         Prove_Word (Clipped (Source (Item)), Sent_With (Frame, Item));
         pragma Loop_Invariant
           (for all Done in Sensor_Item'First .. Item =>
              Spare_Of (Sent (Done)) = Sent_With (Frame, Done)
              and then Without_Spare (Sent (Done)) =
                         Clipped (Source (Done)));
      end loop;
      pragma Assert (Spare_Of (Sent (Right_Flap_1)) = Frame_Mark);
      pragma Assert (Is_Marked (Sent));
      if Is_Sendable (Frame) then
         Prove_Joined
           (Frame (Frame_Number), Sent (Left_Flap_1), Sent (Right_Flap_2),
            Sent (Left_Flap_2));
         Prove_Joined
           (Frame (Left_Aileron), Sent (Right_Elevator),
            Sent (Left_Elevator), Sent (Right_Rudder));
         Prove_Joined
           (Frame (Right_Aileron), Sent (Left_Rudder), Sent (Alpha),
            Sent (Beta));
         Prove_Joined
           (Frame (Left_Elevator), Sent (Altitude_Offset),
            Sent (Lateral_Acceleration), Sent (Longitudinal_Acceleration));
         Prove_Joined
           (Frame (Right_Elevator), Sent (Vertical_Acceleration), Sent (RPM),
            Sent (Battery_Volts));
         Prove_Joined
           (Frame (Left_Rudder), Sent (Alternator_Volts),
            Sent (Roll_Attitude), Sent (Pitch_Attitude));
         Prove_Joined
           (Frame (Right_Rudder), Sent (Roll_Rate), Sent (Pitch_Rate),
            Sent (Yaw_Rate));
         Prove_Joined
           (Frame (Throttle), Sent (Airspeed), Sent (Altitude),
            Sent (Uplink_Signal_Strength));
         pragma Assert (Carried (Sent, Frame_Number) = Frame (Frame_Number));
         pragma Assert (Carried (Sent, Running_Card) = Frame (Running_Card));
         pragma Assert (Carried (Sent, Card_Phase) = Frame (Card_Phase));
         pragma Assert
           (for all Item in Frame_Item =>
              Carried (Sent, Item) = Frame (Item));
      end if;
   end What_Is_Packed_Comes;

   procedure Converter_Words_Come
     (Source : Downlink_Buffer; Frame : Frame_Words) is
   begin
      What_Is_Packed_Comes (Source, Frame);
   end Converter_Words_Come;

   procedure No_Block_Looks_Sealed
     (Source : Downlink_Buffer; Frame : Frame_Words)
   is
      First : constant Word := Packed (Source, Frame) (Right_Flap_1);
   begin
      Prove_Word (Clipped (Source (Right_Flap_1)), Frame_Mark);
      pragma Assert (First / 256 in 16#50# .. 16#5F#);
      pragma Assert
        (URV.Codecs.Downlink.Item_At (1) = Right_Flap_1
         and then
           URV.Codecs.Downlink.Words_Of (Packed (Source, Frame)) (1) = First);
   end No_Block_Looks_Sealed;

   procedure An_Older_Block_Has_No_Frame (Source : Downlink_Buffer) is null;

   procedure Equal_Words_Have_Equal_Frames (One, Other : Downlink_Buffer)
   is
   begin
      for Item in Frame_Item loop
         pragma Assert (Carried (One, Item) = Carried (Other, Item));
         pragma Assert (Is_Carried (One, Item) = Is_Carried (Other, Item));
         pragma Loop_Invariant
           (for all Done in Frame_Item'First .. Item =>
              Frame_In (One) (Done) = Frame_In (Other) (Done));
      end loop;
   end Equal_Words_Have_Equal_Frames;

   procedure Numbers_Count_Frames
     (Before, After : Clock_Tick; Set : Schedule_Name)
   is
      Earlier : constant Tick :=
        (if Set = Fast then 0 else Frame_Numbers - 1);
      First   : constant Tick := Before / Ticks_Per_Major_Frame + Earlier;
      Last    : constant Tick := After / Ticks_Per_Major_Frame + Earlier;
      One     : constant Word := URV.MDCOUT_Steps.Number_Of (Before, Set);
      Other   : constant Word := URV.MDCOUT_Steps.Number_Of (After, Set);
   begin
      Prove_Remainders (First, Last);
      pragma Assert (Tick (One) = First mod Frame_Numbers);
      pragma Assert (Tick (Other) = Last mod Frame_Numbers);
   end Numbers_Count_Frames;

end Theorems.Spare_Bits;
