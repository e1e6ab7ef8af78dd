--  SPDX-License-Identifier: Apache-2.0

with Host.Complaints;   use Host.Complaints;
with Host.Names;
with Host.Orders;
with Host.Text_Input;   use Host.Text_Input;
with Host.Text_Numbers; use Host.Text_Numbers;
with URV.Buffers;       use URV.Buffers;

package body Sim.Conditions is

   use type Number;

   Line_Feed : constant Character := ASCII.LF;

   --  The sensors named in the file so far, to find a repetition.
   type Sensor_Set is array (Sensor_Item) of Boolean;
   type Kind_Set is array (Condition_Kind) of Boolean;
   type Mentioned is record
      Biases  : Sensor_Set := (others => False);
      Spreads : Sensor_Set := (others => False);
      Kinds   : Kind_Set   := (others => False);
   end record;

   function Name (Kind : Condition_Kind) return String is
     (case Kind is
         when Start      => "start",
         when Airframe   => "airframe",
         when Wind       => "wind",
         when Turbulence => "turbulence",
         when Ballast    => "ballast",
         when Servos     => "servos",
         when Bias       => "bias",
         when Noisiness  => "noise");

   function Name (Place : Start_Place) return String is
     (case Place is
         when In_The_Air    => "air",
         when On_The_Runway => "runway");

   --  The aircraft: URV's own, then those of JSBSim's, as in
   --  sim/jsbsim/airframes.py.
   type Airframe_Name is (Lambda, Cessna_172P, Cessna_182, Piper_J3);

   function Name (Item : Airframe_Name) return String is
     (case Item is
         when Lambda      => "lambda",
         when Cessna_172P => "c172p",
         when Cessna_182  => "c182",
         when Piper_J3    => "J3Cub");

   --  Conditions of URV's own aircraft only.
   type Kind_List is array (Positive range <>) of Condition_Kind;
   Own_Only : constant Kind_List := (Start, Wind, Ballast);

   function Airframes_From
     (Item : Airframe_Name; Between : String) return String
   is
     (Name (Item)
      & (if Item = Airframe_Name'Last then ""
         else Between
              & Airframes_From (Airframe_Name'Succ (Item), Between)));

   --  The parameters after the name.
   function Parameters (Kind : Condition_Kind) return String is
     (case Kind is
         when Start      => " air|runway",
         when Airframe   => ' ' & Airframes_From (Lambda, "|"),
         when Wind       => " FROM_DEG KT",
         when Turbulence => " KT",
         when Ballast    => " LB INCHES_AFT",
         when Servos     => " LAG_PERCENT RATE_PERCENT DEAD_BAND_PERCENT",
         when Bias       => " SENSOR VALUE",
         when Noisiness  => " SENSOR VALUE");

   function Parameter_Count (Kind : Condition_Kind) return Positive is
     (case Kind is
         when Start | Airframe | Turbulence => 1,
         when Servos                        => 3,
         when others                        => 2);

   function Form_Of (Kind : Condition_Kind) return String is
     (Name (Kind) & Parameters (Kind));

   function Names_From (Kind : Condition_Kind) return String is
     (Name (Kind)
      & (if Kind = Condition_Kind'Last then ""
         else ", " & Names_From (Condition_Kind'Succ (Kind))));

   function Sensors_From (Item : Sensor_Item) return String is
     (Names.Name (Item)
      & (if Item = Sensor_Item'Last then ""
         else ", " & Sensors_From (Sensor_Item'Succ (Item))));

   --  Reads a number from Least to Most, with or without a sign.
   procedure Read_Number
     (From        : Reader;
      Field_Name  : String;
      Word        : String;
      Least, Most : Integer;
      Value       : out Long_Float);

   procedure Read_Kind
     (From : Reader; Word : String; Kind : out Condition_Kind);

   procedure Read_Sensor
     (From : Reader; Word : String; Item : out Sensor_Item);

   procedure Read_Start
     (From : Reader; Word : String; Loaded : in out Script);

   procedure Read_Airframe
     (From : Reader; Word : String; Loaded : in out Script);

   --  Reads a bias or a noise of a sensor.
   procedure Read_Error
     (From        : Reader;
      Kind        : Condition_Kind;
      Item, Value : String;
      Before      : in out Sensor_Set;
      Errors      : in out Sensor_Values)
     with Pre => Kind in Bias | Noisiness;

   procedure Read_Condition
     (From         : Reader;
      Line         : String;
      Has_Aircraft : Boolean;
      Loaded       : in out Script;
      Before       : in out Mentioned);

   procedure Read_Number
     (From        : Reader;
      Field_Name  : String;
      Word        : String;
      Least, Most : Integer;
      Value       : out Long_Float)
   is
      Decimals    : constant := 6;
      Unit        : constant Long_Float := 10.0 ** Decimals;
      Is_Negative : constant Boolean :=
        Word'Length > 0 and then Word (Word'First) = '-';
      Amount      : Number;
      Is_Valid    : Boolean;
   begin
      Read_Decimal
        (Word (Word'First + (if Is_Negative then 1 else 0) .. Word'Last),
         Decimals, Amount, Is_Valid);
      if Is_Valid and then Amount <= 2 ** 52 then
         Value := Long_Float (Amount) / Unit;
         if Is_Negative then
            Value := -Value;
         end if;
         Is_Valid := Value in Long_Float (Least) .. Long_Float (Most);
      else
         Value := 0.0;
         Is_Valid := False;
      end if;
      if not Is_Valid then
         Refuse
           (From,
            Field_Name & ": " & Quoted (Word) & " is not a number from "
            & Image (Long_Long_Integer (Least)) & " to "
            & Image (Long_Long_Integer (Most)) & " with at most"
            & Integer'Image (Decimals) & " decimals");
      end if;
   end Read_Number;

   procedure Read_Kind
     (From : Reader; Word : String; Kind : out Condition_Kind) is
   begin
      for Known in Condition_Kind loop
         if Name (Known) = Word then
            Kind := Known;
            return;
         end if;
      end loop;
      Refuse
        (From,
         "unknown condition " & Quoted (Word) & "; there are "
         & Names_From (Condition_Kind'First));
   end Read_Kind;

   procedure Read_Sensor
     (From : Reader; Word : String; Item : out Sensor_Item) is
   begin
      for Known in Sensor_Item loop
         if Names.Name (Known) = Word then
            Item := Known;
            return;
         end if;
      end loop;
      Refuse
        (From,
         "unknown sensor " & Quoted (Word) & "; there are "
         & Sensors_From (Sensor_Item'First));
   end Read_Sensor;

   procedure Read_Start
     (From : Reader; Word : String; Loaded : in out Script) is
   begin
      for Known in Start_Place loop
         if Name (Known) = Word then
            Loaded.Begins    := Known;
            Loaded.Has_Start := True;
            return;
         end if;
      end loop;
      Refuse
        (From,
         "start: " & Quoted (Word) & " is neither """ & Name (In_The_Air)
         & """ nor """ & Name (On_The_Runway) & """");
   end Read_Start;

   procedure Read_Airframe
     (From : Reader; Word : String; Loaded : in out Script) is
   begin
      for Known in Airframe_Name loop
         if Name (Known) = Word then
            Loaded.Is_Other := Known /= Lambda;
            return;
         end if;
      end loop;
      Refuse
        (From,
         "unknown airframe " & Quoted (Word) & "; there are "
         & Airframes_From (Lambda, ", "));
   end Read_Airframe;

   procedure Read_Error
     (From        : Reader;
      Kind        : Condition_Kind;
      Item, Value : String;
      Before      : in out Sensor_Set;
      Errors      : in out Sensor_Values)
   is
      --  More than any sensor measures.
      Most   : constant := 10_000;
      Least  : constant Integer := (if Kind = Bias then -Most else 0);
      Sensor : Sensor_Item;
   begin
      Read_Sensor (From, Item, Sensor);
      if Before (Sensor) then
         Refuse
           (From, Name (Kind) & " of " & Item & " is given twice");
      end if;
      Before (Sensor) := True;
      Read_Number (From, "VALUE", Value, Least, Most, Errors (Sensor));
   end Read_Error;

   procedure Read_Condition
     (From         : Reader;
      Line         : String;
      Has_Aircraft : Boolean;
      Loaded       : in out Script;
      Before       : in out Mentioned)
   is
      One_Per_Cent : Host.Bench.Share renames Host.Bench.One_Per_Cent;
      Count  : constant Natural := Orders.Word_Count (Line);
      Kind   : Condition_Kind;
      Number : Long_Float;

      function Word (Index : Positive) return String is
        (Orders.Word (Line, Index));

      procedure Check
        (Index : Positive; Field_Name : String; Least, Most : Integer);

      procedure Check
        (Index : Positive; Field_Name : String; Least, Most : Integer) is
      begin
         Read_Number (From, Field_Name, Word (Index), Least, Most, Number);
      end Check;
   begin
      Read_Kind (From, Word (1), Kind);
      if Kind /= Servos and then not Has_Aircraft then
         Refuse
           (From,
            "the bench has no " & Name (Kind)
            & ", only " & Name (Servos) & ": add --plant jsbsim");
      end if;
      if Count - 1 /= Parameter_Count (Kind) then
         Refuse
           (From, "the form of this condition is " & Form_Of (Kind));
      end if;

      case Kind is
         when Bias =>
            Read_Error
              (From, Kind, Word (2), Word (3), Before.Biases, Loaded.Biases);
            return;
         when Noisiness =>
            Read_Error
              (From, Kind, Word (2), Word (3), Before.Spreads,
               Loaded.Spreads);
            return;
         when Start      => Read_Start (From, Word (2), Loaded);
         when Airframe   => Read_Airframe (From, Word (2), Loaded);
         when Wind       =>
            Check (2, "FROM_DEG", 0, 360);
            Check (3, "KT", 0, 60);
         when Turbulence => Check (2, "KT", 0, 60);
         when Ballast    =>
            Check (2, "LB", -40, 40);
            Check (3, "INCHES_AFT", -40, 40);
         when Servos     =>
            Check (2, "LAG_PERCENT", 10, 1_000);
            Loaded.Servos.Lag :=
              Host.Bench.Share (Number * Long_Float (One_Per_Cent));
            Check (3, "RATE_PERCENT", 10, 1_000);
            Check (4, "DEAD_BAND_PERCENT", 0, 10);
            Loaded.Servos.Dead_Band :=
              Host.Bench.Share (Number * Long_Float (One_Per_Cent));
      end case;

      if Before.Kinds (Kind) then
         Refuse (From, Name (Kind) & " is given twice");
      end if;
      Before.Kinds (Kind) := True;
      for Own of Own_Only loop
         if Loaded.Is_Other and then Before.Kinds (Own) then
            Refuse
              (From,
               Name (Own) & " and another airframe than "
               & Name (Lambda) & " do not go together");
         end if;
      end loop;
      if Kind /= Start then
         Texts.Append
           (Loaded.Lines,
            "condition," & Name (Kind) & ',' & Word (2)
            & (if Count > 2 then ' ' & Word (3) else "")
            & (if Count > 3 then ' ' & Word (4) else "") & Line_Feed);
      end if;
   end Read_Condition;

   procedure Load
     (Loaded : in out Script; File : String; Has_Aircraft : Boolean)
   is
      Before : Mentioned;

      procedure Read (From : Reader; Order : String);

      procedure Read (From : Reader; Order : String) is
      begin
         Read_Condition (From, Order, Has_Aircraft, Loaded, Before);
      end Read;

      procedure Read_All is new Orders.Read_All (Read);
   begin
      Loaded.Is_Given := True;
      Read_All (File);
   end Load;

   function Place
     (Given : Script; Otherwise : Start_Place) return Start_Place
   is (if Given.Has_Start then Given.Begins else Otherwise);

   function Has_Other_Airframe (Given : Script) return Boolean is
     (Given.Is_Other);

   function Introduction
     (Given : Script;
      Seed  : Seed_Number;
      From  : Start_Place) return String
   is
      Seeded : constant Positive :=
        Noise.To_Seed (Noise.Seeded (Seed, Noise.The_Air));
   begin
      return
        (if From = On_The_Runway
         then "condition,start," & Name (From) & Line_Feed else "")
        & (if Given.Is_Given
           then Texts.To_String (Given.Lines) & "condition,seed,"
                & Image (Long_Long_Integer (Seeded)) & Line_Feed
           else "");
   end Introduction;

   function Bench_Servos (Given : Script) return Host.Bench.Servo_Traits is
     (Given.Servos);

   procedure Draw_Errors
     (Given  : Script;
      From   : in out Noise.Source;
      Errors : out Sensor_Values)
   is
      Drawn : Long_Float;
   begin
      Errors := Given.Biases;
      for Item in Sensor_Item loop
         if Given.Spreads (Item) > 0.0 then
            Noise.Draw (From, Drawn);
            Errors (Item) := Errors (Item) + Drawn * Given.Spreads (Item);
         end if;
      end loop;
   end Draw_Errors;

end Sim.Conditions;
