--  SPDX-License-Identifier: Apache-2.0

with URV.Frame_Times; use URV.Frame_Times;

package body URV.Sensor_Checks with SPARK_Mode is

   --  The table is in the body: a prover that sees all its rules takes seconds
   --  for each goal.
   type Rule_Table is array (Law_Item) of Rule;

   --  The largest movement of a word between scans, from words a second,
   --  rounded up.
   Add : constant := Frames_Per_Second - 1;

   Flap_Step           : constant := (10_000 + Add) / Frames_Per_Second;
   Surface_Step        : constant := (30_000 + Add) / Frames_Per_Second;
   Air_Step            : constant := (30_000 + Add) / Frames_Per_Second;
   Offset_Step         : constant := (250 + Add) / Frames_Per_Second;
   RPM_Step            : constant := (25_000 + Add) / Frames_Per_Second;
   Battery_Step        : constant := (25_000 + Add) / Frames_Per_Second;
   Alternator_Step     : constant := (50_000 + Add) / Frames_Per_Second;
   Attitude_Step       : constant := (3_000 + Add) / Frames_Per_Second;
   Roll_Rate_Step      : constant := (20_000 + Add) / Frames_Per_Second;
   Slow_Rate_Step      : constant := (40_000 + Add) / Frames_Per_Second;
   Airspeed_Step       : constant := (16_000 + Add) / Frames_Per_Second;
   Altitude_Step       : constant := (3_000 + Add) / Frames_Per_Second;

   --  Surfaces move at most 100 deg/s, flaps 5. Engine and electrics change
   --  slowly, but some of their limits are the converter's own. The end values
   --  of attitude and rates are invalid: 4095 and 0 mean a broken wire.
   Rules : constant Rule_Table :=
     (Right_Flap_1  => (1, Any, Flap_Step, Right_Flap_1, Any),
      Left_Flap_1   => (1, Any, Flap_Step, Left_Flap_1, Any),
      Right_Flap_2  => (1, Any, Flap_Step, Right_Flap_2, Any),
      Left_Flap_2   => (1, Any, Flap_Step, Left_Flap_2, Any),
      Right_Aileron => (1, 4_094, Surface_Step, Right_Aileron, Any),
      Left_Aileron  => (1, 4_094, Surface_Step, Left_Aileron, Any),
      Right_Elevator => (1, 4_094, Surface_Step, Right_Elevator, Any),
      Left_Elevator => (1, 4_094, Surface_Step, Left_Elevator, Any),
      Right_Rudder  => (1, 4_094, Surface_Step, Right_Rudder, Any),
      Left_Rudder   => (1, 4_094, Surface_Step, Left_Rudder, Any),
      Alpha         => (1, 4_094, Air_Step, Alpha, Any),
      Beta          => (1, 4_094, Air_Step, Beta, Any),
      Altitude_Offset => (0, 4_000, Offset_Step, Altitude_Offset, Any),
      Lateral_Acceleration      => (1, 4_094, Any, Lateral_Acceleration, Any),
      Longitudinal_Acceleration =>
        (1, 4_094, Any, Longitudinal_Acceleration, Any),
      Vertical_Acceleration     => (1, 4_094, Any, Vertical_Acceleration, Any),
      RPM              => (0, 4_000, RPM_Step, RPM, Any),
      Battery_Volts    => (500, 4_000, Battery_Step, Battery_Volts, Any),
      Alternator_Volts => (0, 4_000, Alternator_Step, Alternator_Volts, Any),
      Roll_Attitude    => (1, 4_094, Attitude_Step, Roll_Rate, 100),
      Pitch_Attitude   => (1, 4_094, Attitude_Step, Pitch_Rate, 200),
      Roll_Rate        => (1, 4_094, Roll_Rate_Step, Roll_Attitude, 340),
      Pitch_Rate       => (1, 4_094, Slow_Rate_Step, Pitch_Attitude, 340),
      Yaw_Rate         => (1, 4_094, Slow_Rate_Step, Roll_Attitude, 340),
      Airspeed         => (0, 4_000, Airspeed_Step, Altitude, 400),
      Altitude         => (0, 4_094, Altitude_Step, Pitch_Attitude, 340));

   function Rule_Of (Item : Sensor_Item) return Rule is
     (if Item in Law_Item then Rules (Item) else (0, Any, Any, Item, Any));

   --  One check in place, each condition computed once.

   procedure Take_Frame
     (This : in out Check; Scan : Downlink_Buffer; Item : Sensor_Item)
   with
     Global => null,
     Post   => This = After_Frame (This'Old, Scan, Item);

   procedure Take_Gap (This : in out Check)
   with
     Global => null,
     Post   => This = After_Gap (This'Old);

   procedure Take_Word
     (This : in out Check; Value, Witness : Word; By : Rule)
   with
     Global => null,
     Post   => This = After_Scan (This'Old, Value, Witness, By);

   procedure Take_Gap (This : in out Check) is
   begin
      if This.Bad >= Bad_Scans - 1 then
         This.Is_Valid := False;
         This.Bad := Bad_Scans;
         This.Good := 0;
      else
         This.Bad := This.Bad + 1;
      end if;
   end Take_Gap;

   procedure Take_Word
     (This : in out Check; Value, Witness : Word; By : Rule)
   is
      Is_Plausible : constant Boolean :=
        Is_In_Range (Value, By) and then Is_Slow (This, Value, By);
   begin
      if not This.Is_Seen or else Value /= This.Anchor then
         This.Is_Seen := True;
         This.Anchor := Value;
         This.Witnessed := Witness;
         This.Stuck := 0;
      elsif not Has_Left (This, Witness, By) then
         This.Stuck := 0;
      elsif This.Stuck < Stuck_Scans then
         This.Stuck := This.Stuck + 1;
      end if;
      This.Last := Value;

      if Is_Plausible and then This.Stuck < Stuck_Scans then
         if not This.Is_Valid then
            This.Is_Valid := This.Good >= Good_Scans - 1;
         end if;
         This.Used := Value;
         This.Bad := 0;
         if This.Good < Good_Scans then
            This.Good := This.Good + 1;
         end if;
      else
         This.Is_Valid := This.Is_Valid
           and then This.Bad < Bad_Scans - 1
           and then This.Stuck < Stuck_Scans;
         if This.Bad < Bad_Scans then
            This.Bad := This.Bad + 1;
         end if;
         This.Good := 0;
      end if;
   end Take_Word;

   procedure Take_Frame
     (This : in out Check; Scan : Downlink_Buffer; Item : Sensor_Item) is
   begin
      if (Scan (Error_Status) and Stale_Data) /= 0 then
         Take_Gap (This);
      else
         Take_Word
           (This, Scan (Item), Scan (Rule_Of (Item).Witness), Rule_Of (Item));
      end if;
   end Take_Frame;

   procedure Advance (Items : in out Check_Table; Scan : Downlink_Buffer) is
   begin
      for Item in Sensor_Item loop
         pragma Assert (Items (Item) = Items'Loop_Entry (Item));
         Take_Frame (Items (Item), Scan, Item);
         pragma Loop_Invariant
           (for all Done in Sensor_Item'First .. Item =>
              Items (Done) =
                After_Frame (Items'Loop_Entry (Done), Scan, Done));
         pragma Loop_Invariant
           (for all Later in Sensor_Item =>
              (if Later > Item
               then Items (Later) = Items'Loop_Entry (Later)));
      end loop;
   end Advance;

   function Invalid_Bits (Items : Check_Table; Which : Half) return Word is
      First  : constant Sensor_Item := Sensor_Item'Val (16 * Integer (Which));
      Last   : constant Sensor_Item :=
        (if Which = Half'Last then Sensor_Item'Last
         else Sensor_Item'Val (Sensor_Item'Pos (First) + 15));
      Result : Word := 0;
      Bit    : Word := 1;
   begin
      for Item in First .. Last loop
         if not Items (Item).Is_Valid then
            Result := Result or Bit;
         end if;
         Bit := Bit * 2;
      end loop;
      return Result;
   end Invalid_Bits;

end URV.Sensor_Checks;
