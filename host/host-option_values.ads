--  SPDX-License-Identifier: Apache-2.0

--  Parses the values of options. Title is the option's name, with its dashes.
--  An invalid value is refused, with the valid choices: raises Bad_Input.

with Host.Text_Numbers; use Host.Text_Numbers;
with Telemetry;
with URVOS.Task_Trees;

package Host.Option_Values is

   --  Seconds with at most six decimals, above 0 and up to the longest, which
   --  is whole seconds.
   function Time_Of
     (Title   : String;
      Value   : String;
      Longest : Microseconds) return Microseconds;

   --  The range that the boards allow: "0 to 1.392".
   function Line_Delay_Range return String;

   --  The longest --line-delay, in microseconds: 0 where a frame has no room
   --  for a slow line.
   function Longest_Line_Delay return Host.Text_Numbers.Number;

   --  Microseconds, from a value in milliseconds with at most three decimals.
   function Line_Delay_Of
     (Title : String;
      Value : String) return Telemetry.Line_Delay;

   --  From 0 to Last.
   function Whole_Of
     (Title : String;
      Value : String;
      Last  : Number) return Number;

   --  From -Last to Last.
   function Signed_Of
     (Title : String;
      Value : String;
      Last  : Natural) return Integer;

   subtype One_Or_Two is Positive range 1 .. 2;

   function Number_Of (Title : String; Value : String) return One_Or_Two;

   subtype One_To_Three is Positive range 1 .. 3;

   function Version_Of (Title : String; Value : String) return One_To_Three;

   --  The processors of a node: "1 to 4".
   function Processor_Range return String;

   function Processors_Of
     (Title : String;
      Value : String) return URVOS.Task_Trees.Processor_Number;

   --  True if the value is the first of two words, False if the second.
   function Is_First
     (Title  : String;
      Value  : String;
      First  : String;
      Second : String) return Boolean;

   procedure Refuse_Value (Title : String; Value : String; Problem : String)
     with No_Return;

end Host.Option_Values;
