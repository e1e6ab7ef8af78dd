--  SPDX-License-Identifier: Apache-2.0

with Host.Complaints;   use Host.Complaints;
with Host.Text_Numbers; use Host.Text_Numbers;

package body Host.Loss_Times is

   use type Number;

   Orbit_Option  : constant String := "--orbit-after";
   Finish_Option : constant String := "--terminate-after";

   --  A time in tenths of a second from First to Last.
   function Tenths_Of
     (Option, Value, Its_Range : String; First, Last : Field) return Field;

   --  Tenths as text: "0.5".
   function Seconds (Tenths : Field) return String is
     (Image (Long_Long_Integer (Tenths / 10))
      & (if Tenths mod 10 = 0 then ""
         else "." & Image (Long_Long_Integer (Tenths mod 10))));

   function Tenths_Of
     (Option, Value, Its_Range : String; First, Last : Field) return Field
   is
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      Read_Decimal (Value, 1, Amount, Is_Valid);
      if not Is_Valid or else Amount not in Number (First) .. Number (Last)
      then
         Refuse
           (Option & ": " & Quoted (Value) & " is not a number of seconds"
            & " from " & Its_Range & " with at most one decimal");
      end if;
      return Field (Amount);
   end Tenths_Of;

   procedure Read_Orbit (Value : String; Item : in out Pair) is
   begin
      Item.Orbit :=
        Tenths_Of
          (Orbit_Option, Value, Orbit_Range, Orbit_Tenths'First,
           Orbit_Tenths'Last);
   end Read_Orbit;

   procedure Read_Finish (Value : String; Item : in out Pair) is
   begin
      Item.Finish :=
        Tenths_Of
          (Finish_Option, Value, Finish_Range, End_Tenths'First,
           End_Tenths'Last);
   end Read_Finish;

   procedure Check (Item : Pair; Is_Given, Has_Laws : Boolean) is
   begin
      if Is_Given and then not Has_Laws then
         Refuse
           (Orbit_Option & " and " & Finish_Option
            & " are times of the control laws: add --laws on");
      elsif Item.Finish <= Item.Orbit then
         Refuse
           (Finish_Option & ": " & Seconds (Item.Finish)
            & " s do not come after the " & Seconds (Item.Orbit) & " s of "
            & Orbit_Option);
      end if;
   end Check;

   function Frames_Of (Item : Pair) return URV.Link_Loss.Times is
     (Times_Of
        ((Serial     => Serial_Number'First,
          Gains      => 0,
          Orbit_From => Item.Orbit,
          End_From   => Item.Finish)));

end Host.Loss_Times;
