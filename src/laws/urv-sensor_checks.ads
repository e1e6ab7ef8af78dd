--  SPDX-License-Identifier: Apache-2.0

--  Which sensors can be believed (EXT-3, FRM-7): each word is looked at in
--  each scan, for three things.
--
--  range  the word is one that the sensor can give
--  rate   it has not moved further since the last good one than it can
--  stuck  it has not stood still while its witness, another sensor that
--         cannot move alone, went away
--
--  A sensor is not valid after 0.06 s of bad scans one after the other, three
--  in frames of 20 ms, or when it is stuck; and valid again after a second of
--  good ones. A scan that did
--  not come is a bad one of every sensor. Until it is found not valid the
--  last good word stands for it.

with URVOS;         use URVOS;
with URV.Buffers;   use URV.Buffers;
with URV.Law_Gains; use URV.Law_Gains;

package URV.Sensor_Checks with Pure, SPARK_Mode is

   --  What a sensor's words are held to. A witness that is the sensor
   --  itself is none.
   type Rule is record
      Least, Most : Converter_Value;
      Step        : Converter_Value;
      Witness     : Sensor_Item;
      Travel      : Converter_Value;
   end record;

   Any : constant Converter_Value := Converter_Value'Last;

   --  What a control law or a monitor may read: each has a rule of its own.
   subtype Law_Item is Sensor_Item range Right_Flap_1 .. Altitude;

   --  Of a sensor behind them every word of the converter is good.
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

   --  What is known of a sensor: its last good word, how many scans were
   --  bad, then good; since when it has not moved, and where its witness
   --  was then.
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

   type Check_Table is array (Sensor_Item) of Check;

   --  The word that stands for a sensor: the last good one.
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
      "so many bad scans overflow the word in Is_Slow");

   --  From the last good word while the sensor is valid, so that what has
   --  jumped away stays away; else from the last one.
   function Is_Slow (This : Check; Value : Word; By : Rule) return Boolean is
     (Distance
        (Value, (if This.Is_Valid then This.Used else This.Last)) <=
          By.Step * Word (1 + This.Bad))
   with Global => null;

   function Has_Left (This : Check; Witness : Word; By : Rule) return Boolean
   is (Distance (Witness, This.Witnessed) > By.Travel)
   with Global => null;

   --  Scans in which the witness was away and this did not move.
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

   --  Nothing bad about the word.
   function Is_Good
     (This : Check; Value, Witness : Word; By : Rule) return Boolean
   is
     (Is_In_Range (Value, By)
      and then Is_Slow (This, Value, By)
      and then Next_Stuck (This, Value, Witness, By) < Stuck_Scans)
   with Global => null;

   --  What is known after a frame without a scan, and with one.

   function After_Gap (This : Check) return Check is
     ((This with delta
        Bad      => (if This.Bad = Bad_Scans then Bad_Scans
                     else This.Bad + 1),
        Good     => 0,
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

   --  All of a scan, or without one.

   function Next (Items : Check_Table; Scan : Downlink_Buffer)
                  return Check_Table
   is
     ((for Item in Sensor_Item =>
         (if (Scan (Error_Status) and Stale_Data) /= 0
          then After_Gap (Items (Item))
          else After_Scan
            (Items (Item), Scan (Item), Scan (Rule_Of (Item).Witness),
             Rule_Of (Item)))))
   with
     Global => null,
     Post   =>
       (for all Item in Sensor_Item =>
          (if Next'Result (Item).Is_Valid
           then Items (Item).Is_Valid
             or else Next'Result (Item).Good = Good_Scans));

   --  The aircraft is known to be on the ground: it is slow and low, and both
   --  sensors are valid. Whatever is not known counts as flying (EXT-5,
   --  SAF-10).
   function Is_On_Ground (Items : Check_Table) return Boolean is
     (Items (Airspeed).Is_Valid
      and then Items (Altitude).Is_Valid
      and then Word_Of (Items, Airspeed) < Flying_Speed
      and then Word_Of (Items, Altitude) < Flying_Height)
   with Global => null;

   --  A bit for each sensor that is not valid, the first in bit 0, in two
   --  words.

   type Half is range 0 .. 1;

   function Invalid_Bits (Items : Check_Table; Which : Half) return Word;

end URV.Sensor_Checks;
