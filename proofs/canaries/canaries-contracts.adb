--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Contracts with SPARK_Mode is

   procedure Count_Up (Value : in out Count) is
   begin
      Value := Incremented (Value);
   end Count_Up;

   procedure Keep_Low (Value : in out Byte) is
   begin
      Value := Byte'Min (Value, 16);
   end Keep_Low;

   procedure Keep_Away (Value : in out Byte) is
   begin
      Value := (if Value < 16 then 0 else 255);
   end Keep_Away;

   procedure Split (Value : in out Even) is
   begin
      Value := Value / 2;  --  VC_PREDICATE_CHECK
   end Split;

   procedure Make_Pair (Sum : out Word) is
      Made : Pair;  --  VC_PREDICATE_CHECK_ON_DEFAULT_VALUE
   begin
      Sum := Made.First + Made.Second;
   end Make_Pair;

   procedure Triple (Value : Byte) is
      Result : constant Word := 3 * Word (Value);
   begin
      pragma Assert (Result <= 765);
      pragma Assert ((Result > 255) = (Value > 86));  --  VC_ASSERT
   end Triple;

   procedure Successor_Is_Larger (Value : Word) is null;

   procedure Apart_From_One (Left, Right : Byte) is null;

end Canaries.Contracts;
