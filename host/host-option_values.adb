--  SPDX-License-Identifier: Apache-2.0

with Host.Complaints; use Host.Complaints;

package body Host.Option_Values is

   use type Number;

   procedure Refuse_Value (Title : String; Value : String; Problem : String) is
   begin
      Refuse (Title & ": " & Quoted (Value) & " is " & Problem);
   end Refuse_Value;

   procedure Refuse_Unless
     (Is_Valid : Boolean;
      Title    : String;
      Value    : String;
      Problem  : String);

   procedure Refuse_Unless
     (Is_Valid : Boolean;
      Title    : String;
      Value    : String;
      Problem  : String) is
   begin
      if not Is_Valid then
         Refuse_Value (Title, Value, Problem);
      end if;
   end Refuse_Unless;

   function Time_Of
     (Title   : String;
      Value   : String;
      Longest : Microseconds) return Microseconds
   is
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      Read_Decimal (Value, 6, Amount, Is_Valid);
      Refuse_Unless
        (Is_Valid and then Amount in 1 .. Number (Longest), Title, Value,
         "not a number of seconds above 0 and up to"
         & Microseconds'Image (Longest / Microseconds_Per_Second)
         & " with at most six decimals");
      return Microseconds (Amount);
   end Time_Of;

   function Longest_Line_Delay return Number is
     (Number (Telemetry.Line_Delay'Last));

   function Line_Delay_Range return String is
     ("0 to " & Thousandths_Image (Longest_Line_Delay));

   function Line_Delay_Of
     (Title : String;
      Value : String) return Telemetry.Line_Delay
   is
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      Read_Decimal (Value, 3, Amount, Is_Valid);
      Refuse_Unless
        (Is_Valid and then Amount <= Longest_Line_Delay, Title, Value,
         "not a number of milliseconds from " & Line_Delay_Range
         & " with at most three decimals: a frame has no room for an exchange"
         & " over a slower line");
      return Telemetry.Line_Delay (Amount);
   end Line_Delay_Of;

   function Whole_Of
     (Title : String;
      Value : String;
      Last  : Number) return Number
   is
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      Read_Whole (Value, Amount, Is_Valid);
      Refuse_Unless
        (Is_Valid and then Amount <= Last, Title, Value,
         "not a whole number from 0 to" & Last'Image);
      return Amount;
   end Whole_Of;

   function Signed_Of
     (Title : String;
      Value : String;
      Last  : Natural) return Integer
   is
      Is_Minus : constant Boolean :=
        Value'Length > 1 and then Value (Value'First) = '-';
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      Read_Whole
        (Value (Value'First + Boolean'Pos (Is_Minus) .. Value'Last), Amount,
         Is_Valid);
      Refuse_Unless
        (Is_Valid and then Amount <= Number (Last), Title, Value,
         "not a whole number from " & Integer'Image (-Last) & " to"
         & Last'Image);
      return (if Is_Minus then -Integer (Amount) else Integer (Amount));
   end Signed_Of;

   function Number_Of (Title : String; Value : String) return One_Or_Two is
   begin
      Refuse_Unless
        (Value in "1" | "2", Title, Value, "neither 1 nor 2");
      return (if Value = "1" then 1 else 2);
   end Number_Of;

   function Version_Of (Title : String; Value : String) return One_To_Three is
   begin
      Refuse_Unless
        (Value in "1" | "2" | "3", Title, Value, "neither 1, 2 nor 3");
      return (if Value = "1" then 1 elsif Value = "2" then 2 else 3);
   end Version_Of;

   function Processor_Range return String is
     ("1 to" & URVOS.Task_Trees.Processor_Number'Last'Image);

   function Processors_Of
     (Title : String;
      Value : String) return URVOS.Task_Trees.Processor_Number
   is
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      Read_Whole (Value, Amount, Is_Valid);
      Refuse_Unless
        (Is_Valid
           and then Amount in
             1 .. Number (URVOS.Task_Trees.Processor_Number'Last),
         Title, Value, "not a number of processors from " & Processor_Range);
      return URVOS.Task_Trees.Processor_Number (Amount);
   end Processors_Of;

   function Is_First
     (Title  : String;
      Value  : String;
      First  : String;
      Second : String) return Boolean is
   begin
      Refuse_Unless
        (Value = First or else Value = Second, Title, Value,
         "neither """ & First & """ nor """ & Second & '"');
      return Value = First;
   end Is_First;

end Host.Option_Values;
