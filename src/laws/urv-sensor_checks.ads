--  SPDX-License-Identifier: Apache-2.0

--  The validity of each sensor (EXT-3, FRM-7). Each scan checks each word in
--  three ways.
--
--  range  the sensor can give this word
--  rate   since the last good word it moved no further than the sensor can
--  stuck  it moved while that of its witness, a related sensor, moved away
--
--  A sensor becomes invalid after 0.06 s of bad scans in a row, which is three
--  in frames of 20 ms, or when it is stuck. It is valid again after one second
--  of good scans. A missing scan is a bad scan of every sensor, but one or two
--  in a row do not begin that second again: a link may lose every other
--  downlink. Until the sensor is invalid, its last good word replaces bad
--  ones.

with URVOS;         use URVOS;
with URV.Buffers;   use URV.Buffers;
with URV.Law_Gains; use URV.Law_Gains;

package URV.Sensor_Checks with Pure, SPARK_Mode is

   --  The limits for a sensor's words. A sensor that is its own witness has no
   --  witness.
   type Rule is record
      Least, Most : Converter_Value;
      Step        : Converter_Value;
      Witness     : Sensor_Item;
      Travel      : Converter_Value;
   end record;

   Any : constant Converter_Value := Converter_Value'Last;

   --  The sensors that a control law or a monitor may read; each has a rule.
   subtype Law_Item is Sensor_Item range Right_Flap_1 .. Altitude;

   --  For later sensors every word of the converter is good.
   function Rule_Of (Item : Sensor_Item) return Rule
   with
     Inline,
     Global => null,
     Post   =>
       (if Item not in Law_Item
        then Rule_Of'Result = (0, Any, Any, Item, Any));

   subtype Bad_Count is Natural range 0 .. Bad_Scans;
   subtype Good_Count is Natural range 0 .. Good_Scans;
   subtype Stuck_Count is Natural range 0 .. Stuck_Scans;

   --  The state of a sensor: its last good word; the number of bad scans in a
   --  row; the number of good scans since the last bad word or the last
   --  Bad_Scans missing scans in a row; the word at which it last moved, its
   --  witness's word then, and the stuck scans since.
   type Check is record
      Is_Seen    : Boolean         := False;
      Is_Valid   : Boolean         := False;
      Used       : Converter_Value := Neutral_Value;
      Last       : Word            := Neutral_Value;
      Bad        : Bad_Count       := 0;
      Good       : Good_Count      := 0;
      Anchor     : Word            := Neutral_Value;
      Witnessed  : Word            := Neutral_Value;
      Stuck      : Stuck_Count     := 0;
   end record;

   --  Sixteen bytes: a table of them is the largest part of LAW's memory.
   for Check use record
      Is_Seen   at  0 range 0 ..  7;
      Is_Valid  at  1 range 0 ..  7;
      Used      at  2 range 0 .. 15;
      Last      at  4 range 0 .. 15;
      Anchor    at  6 range 0 .. 15;
      Witnessed at  8 range 0 .. 15;
      Bad       at 10 range 0 .. 15;
      Good      at 12 range 0 .. 15;
      Stuck     at 14 range 0 .. 15;
   end record;

   type Check_Table is array (Sensor_Item) of Check;

   --  The word used for a sensor: the last good one.
   function Word_Of (Items : Check_Table; Item : Law_Item)
                     return Converter_Value
   is
     (Items (Item).Used)
   with Global => null;

   function Distance (One, Other : Word) return Word is
     (if One > Other then One - Other else Other - One)
   with Global => null;

   function Is_In_Range (Value : Word; By : Rule) return Boolean is
     (Value in By.Least .. By.Most)
   with Global => null;

   pragma Compile_Time_Error
     ((1 + Bad_Scans) * 4_095 > 65_535,
      "the number of bad scans overflows the word in Is_Slow");

   --  For a valid sensor the distance is from the last good word, so a word
   --  that has jumped remains bad. For an invalid one it is from the last
   --  word.
   function Is_Slow (This : Check; Value : Word; By : Rule) return Boolean is
     (Distance
        (Value, (if This.Is_Valid then This.Used else This.Last)) <=
          (if This.Bad = 0 then By.Step else By.Step * Word (1 + This.Bad)))
   with Global => null;

   function Has_Left (This : Check; Witness : Word; By : Rule) return Boolean
   is (Distance (Witness, This.Witnessed) > By.Travel)
   with Global => null;

   --  Scans in a row in which the witness was away and this word did not move.
   function Next_Stuck
     (This : Check; Value, Witness : Word; By : Rule) return Stuck_Count
   is
     (if not This.Is_Seen
        or else Value /= This.Anchor
        or else not Has_Left (This, Witness, By)
      then 0
      elsif This.Stuck = Stuck_Scans then Stuck_Scans
      else This.Stuck + 1)
   with Global => null;

   --  The word passes all three checks.
   function Is_Good
     (This : Check; Value, Witness : Word; By : Rule) return Boolean
   is
     (Is_In_Range (Value, By)
      and then Is_Slow (This, Value, By)
      and then Next_Stuck (This, Value, Witness, By) < Stuck_Scans)
   with Global => null;

   --  The check after a frame without a scan, and after one with a scan

   function After_Gap (This : Check) return Check is
     ((This with delta
        Bad      => (if This.Bad = Bad_Scans then Bad_Scans
                     else This.Bad + 1),
        Good     => (if This.Bad >= Bad_Scans - 1 then 0 else This.Good),
        Is_Valid => This.Is_Valid and then This.Bad < Bad_Scans - 1))
   with Global => null;

   function After_Scan
     (This : Check; Value, Witness : Word; By : Rule) return Check
   is
     (Is_Seen   => True,
      Is_Valid  =>
        (if Is_Good (This, Value, Witness, By)
         then This.Is_Valid or else This.Good >= Good_Scans - 1
         else This.Is_Valid
           and then This.Bad < Bad_Scans - 1
           and then Next_Stuck (This, Value, Witness, By) < Stuck_Scans),
      Used      =>
        (if Is_Good (This, Value, Witness, By)
         then Value else This.Used),
      Last      => Value,
      Bad       =>
        (if Is_Good (This, Value, Witness, By) then 0
         elsif This.Bad = Bad_Scans then Bad_Scans
         else This.Bad + 1),
      Good      =>
        (if not Is_Good (This, Value, Witness, By) then 0
         elsif This.Good = Good_Scans then Good_Scans
         else This.Good + 1),
      Anchor    => Value,
      Witnessed =>
        (if not This.Is_Seen or else Value /= This.Anchor
         then Witness else This.Witnessed),
      Stuck     => Next_Stuck (This, Value, Witness, By))
   with Global => null;

   --  A sensor's check, and all checks, after a frame with or without a scan

   function After_Frame
     (This : Check; Scan : Downlink_Buffer; Item : Sensor_Item) return Check
   is
     (if (Scan (Error_Status) and Stale_Data) /= 0
      then After_Gap (This)
      else After_Scan
        (This, Scan (Item), Scan (Rule_Of (Item).Witness), Rule_Of (Item)))
   with Global => null;

   function Next (Items : Check_Table; Scan : Downlink_Buffer)
                  return Check_Table
   is
     ((for Item in Sensor_Item => After_Frame (Items (Item), Scan, Item)))
   with
     Global => null,
     Post   =>
       (for all Item in Sensor_Item =>
          (if Next'Result (Item).Is_Valid
           then Items (Item).Is_Valid
             or else Next'Result (Item).Good = Good_Scans));

   --  The same in place.
   procedure Advance (Items : in out Check_Table; Scan : Downlink_Buffer)
   with
     Global => null,
     Post   => Items = Next (Items'Old, Scan);

   --  The aircraft is known to be on the ground: it is slow and low, and both
   --  sensors are valid. In all other cases it counts as flying (EXT-5,
   --  SAF-10).
   function Is_On_Ground (Items : Check_Table) return Boolean is
     (Items (Airspeed).Is_Valid
      and then Items (Altitude).Is_Valid
      and then Word_Of (Items, Airspeed) < Flying_Speed
      and then Word_Of (Items, Altitude) < Flying_Height)
   with Global => null;

   --  A bit for each invalid sensor, the first in bit 0, in two words

   type Half is range 0 .. 1;

   function Invalid_Bits (Items : Check_Table; Which : Half) return Word;

end URV.Sensor_Checks;
