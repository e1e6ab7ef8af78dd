--  SPDX-License-Identifier: Apache-2.0

package body URV.Spare_Bits with SPARK_Mode is

   --  A word with its spare bits.
   function With_Spare (Value : Word; Spare : Nibble) return Word is
     (Clipped (Value) or Spare * Spare_Unit)
   with Global => null;

   --  Three words with those of a value of 12 bits.
   procedure Pack_Value (One, Two, Three : in out Word; Value : Word)
   with
     Inline,
     Global => null,
     Post   =>
       One = With_Spare (One'Old, High (Value))
       and then Two = With_Spare (Two'Old, Middle (Value))
       and then Three = With_Spare (Three'Old, Low (Value));

   procedure Pack_Value (One, Two, Three : in out Word; Value : Word) is
   begin
      One := With_Spare (One, High (Value));
      Two := With_Spare (Two, Middle (Value));
      Three := With_Spare (Three, Low (Value));
   end Pack_Value;

   --  Limits the sensors after the last one that carries bits, if any.
   procedure Clip_Later (This : in out Downlink_Buffer)
   with
     Inline,
     Global => null,
     Post   =>
       (for all Item in Downlink_Item =>
          This (Item) =
            (if Item in Sensor_Item and then Item > Uplink_Signal_Strength
             then Clipped (This'Old (Item)) else This'Old (Item)));

   procedure Clip_Later (This : in out Downlink_Buffer) is
   begin
      for Item in reverse Sensor_Item loop
         exit when Item = Uplink_Signal_Strength;
         This (Item) := Clipped (This (Item));
         pragma Loop_Invariant
           (for all Each in Downlink_Item =>
              This (Each) =
                (if Each in Sensor_Item and then Each >= Item
                 then Clipped (This'Loop_Entry (Each))
                 else This'Loop_Entry (Each)));
      end loop;
   end Clip_Later;

   procedure Pack (This : in out Downlink_Buffer; Frame : Frame_Words) is
      Before : constant Downlink_Buffer := This with Ghost;
   begin
      Clip_Later (This);
      This (Right_Flap_1) := With_Spare (This (Right_Flap_1), Frame_Mark);
      Pack_Value
        (This (Left_Flap_1), This (Right_Flap_2), This (Left_Flap_2),
         Frame (Frame_Number));
      This (Right_Aileron) :=
        With_Spare (This (Right_Aileron), Low (Frame (Running_Card)));
      This (Left_Aileron) :=
        With_Spare (This (Left_Aileron), Low (Frame (Card_Phase)));
      Pack_Value
        (This (Right_Elevator), This (Left_Elevator),
         This (Right_Rudder), Frame (Left_Aileron));
      Pack_Value
        (This (Left_Rudder), This (Alpha),
         This (Beta), Frame (Right_Aileron));
      Pack_Value
        (This (Altitude_Offset), This (Lateral_Acceleration),
         This (Longitudinal_Acceleration), Frame (Left_Elevator));
      Pack_Value
        (This (Vertical_Acceleration), This (RPM),
         This (Battery_Volts), Frame (Right_Elevator));
      Pack_Value
        (This (Alternator_Volts), This (Roll_Attitude),
         This (Pitch_Attitude), Frame (Left_Rudder));
      Pack_Value
        (This (Roll_Rate), This (Pitch_Rate),
         This (Yaw_Rate), Frame (Right_Rudder));
      Pack_Value
        (This (Airspeed), This (Altitude),
         This (Uplink_Signal_Strength), Frame (Throttle));

      --  Each word, for the proof.
      pragma Assert (This (Error_Status) = Before (Error_Status));
      pragma Assert
        (for all Item in Sensor_Item =>
           This (Item) =
             With_Spare (Before (Item), Sent_With (Frame, Item)));
   end Pack;

   procedure Unpack
     (Words : in out Downlink_Buffer; Frame : out Frame_Words) is
   begin
      Frame := Frame_In (Words);
      if Is_Marked (Words) then
         for Item in Sensor_Item loop
            Words (Item) := Without_Spare (Words (Item));
            pragma Loop_Invariant
              (for all Each in Sensor_Item =>
                 Words (Each) =
                   (if Each <= Item
                    then Without_Spare (Words'Loop_Entry (Each))
                    else Words'Loop_Entry (Each)));
            pragma Loop_Invariant
              (Words (Error_Status) = Words'Loop_Entry (Error_Status));
         end loop;
      end if;
   end Unpack;

end URV.Spare_Bits;
