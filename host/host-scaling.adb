--  SPDX-License-Identifier: Apache-2.0

with Ada.Long_Float_Text_IO;
with Ada.Strings.Fixed; use Ada.Strings, Ada.Strings.Fixed;

with Host.Limits;      use Host.Limits;
with Host.Names;       use Host.Names;
with Host.Text_Output; use Host.Text_Output;
with URV.Law_Status;

package body Host.Scaling is

   --  Without trailing zeros. Four decimals suffice: the finest word is 0.001.
   function Image (Value : Long_Float; Decimals : Positive := 4)
                   return String;

   --  Empty for no limit.
   function Image_Or_Empty (Limit : Long_Float) return String;

   function Symbol (Of_Unit : Unit) return String is
     (case Of_Unit is
         when Degrees                => "deg",
         when Degrees_Per_Second     => "deg/s",
         when Feet                   => "ft",
         when Knots                  => "kt",
         when Standard_Gravity       => "g",
         when Revolutions_Per_Minute => "rev/min",
         when Volts                  => "V",
         when Decibel_Milliwatts     => "dBm",
         when Percent                => "%",
         when On_Off                 => "on");

   function To_Word (Value : Long_Float; Item : Scale) return Converter_Value
   is
      Exact : constant Long_Float := (Value - Item.At_0) / Item.Per_Word;
   begin
      if Exact >= Long_Float (Converter_Value'Last) then
         return Converter_Value'Last;
      elsif Exact > 0.0 then
         --  A conversion to an integer rounds to the nearest.
         return Converter_Value (Exact);
      else
         return 0;
      end if;
   end To_Word;

   function Image (Value : Long_Float; Decimals : Positive := 4)
                   return String
   is
      Text : String (1 .. 20);
      Last : Positive := Text'Last;
   begin
      Ada.Long_Float_Text_IO.Put (Text, Value, Aft => Decimals, Exp => 0);
      while Text (Last) = '0' loop
         Last := Last - 1;
      end loop;
      if Text (Last) = '.' then
         Last := Last - 1;
      end if;
      return Trim (Text (1 .. Last), Left);
   end Image;

   function Image_Or_Empty (Limit : Long_Float) return String is
     (if Limit in Long_Float'First | Long_Float'Last then ""
      else Image (Limit));

   procedure Print (To : in out Text_Output.Writer) is

      procedure Put_Item
        (Name     : String;
         Buffer   : String;
         Position : Natural;
         Columns  : String;
         Uses     : String := ",");

      procedure Put_Item
        (Name     : String;
         Buffer   : String;
         Position : Natural;
         Columns  : String;
         Uses     : String := ",") is
      begin
         Put_Line
           (To,
            Name & ',' & Buffer & ','
            & Trim (Natural'Image (Position + 1), Left) & ',' & Columns
            & ',' & Uses);
      end Put_Item;

      Without_Scale : constant String := ",,,,,,,,";

      Without_Limits : constant Limit_Set := (others => <>);

      function Columns (Limits : Limit_Set) return String is
        (Image_Or_Empty (Limits.Warning_Low)
         & ',' & Image_Or_Empty (Limits.Caution_Low)
         & ',' & Image_Or_Empty (Limits.Caution_High)
         & ',' & Image_Or_Empty (Limits.Warning_High));

      --  With twelve decimals a value is exact to 1E-8 of its unit, and the
      --  zero of every scale is exactly a word.
      function Columns
        (Item : Scale; Limits : Limit_Set := Without_Limits) return String
      is
        (Symbol (Item.Measured_In)
         & ',' & Image (To_Unit (Converter_Value'First, Item))
         & ',' & Image (To_Unit (Converter_Value'Last, Item))
         & ',' & Columns (Limits)
         & ',' & Image (Item.Per_Word, Decimals => 12)
         & ',' & Image (0.0 - Item.At_0 / Item.Per_Word));

   begin
      Put_Line
        (To,
         "name,buffer,position,unit,at_0,at_4095,warning_low,caution_low,"
         & "caution_high,warning_high,per_word,zero_word,label,works");
      for Item in Uplink_Item loop
         Put_Item
           (Name (Item), "uplink", Uplink_Item'Pos (Item),
            (if Item in Command_Item
             then Columns (Sticks (Item)) else Without_Scale),
            (if Item in Switch_Item
             then Label (Item) & ',' & Works (Item) else ","));
      end loop;
      for Item in Downlink_Item loop
         Put_Item
           (Name (Item), "downlink", Downlink_Item'Pos (Item),
            (if Item in Sensor_Item
             then Columns (Sensors (Item), Limits.Sensors (Item))
             else Without_Scale));
      end loop;
      for Item in PWM_Item loop
         Put_Item
           (Name (Item), "pwm", PWM_Item'Pos (Item),
            (if Item in Servo_Item
             then Columns (Servos (Item)) else Without_Scale));
      end loop;
      for Word in URV.Law_Status.Report_Item loop
         if Law_Word_Name (Word) /= "" then
            Put_Item
              (Law_Word_Name (Word), "laws",
               URV.Law_Status.Report_Item'Pos (Word),
               Without_Scale);
         end if;
      end loop;
   end Print;

end Host.Scaling;
