--  SPDX-License-Identifier: Apache-2.0

package body Sim.Noise is

   use Interfaces;
   use type Faults.Character_Bits;
   use type Faults.Probability;

   --  SplitMix64's step and its mixing function.
   procedure Next (From : in out Source; Value : out Unsigned_64)
     with Inline;

   --  The upper half of the product.
   function High_Product (Left, Right : Unsigned_64) return Unsigned_64;

   procedure Next (From : in out Source; Value : out Unsigned_64) is
   begin
      From  := From + 16#9E37_79B9_7F4A_7C15#;
      Value := Unsigned_64 (From);
      Value :=
        (Value xor Shift_Right (Value, 30)) * 16#BF58_476D_1CE4_E5B9#;
      Value :=
        (Value xor Shift_Right (Value, 27)) * 16#94D0_49BB_1331_11EB#;
      Value := Value xor Shift_Right (Value, 31);
   end Next;

   function High_Product (Left, Right : Unsigned_64) return Unsigned_64 is
      Half   : constant Unsigned_64 := 2 ** 32;
      Low    : constant Unsigned_64 := (Left mod Half) * (Right mod Half);
      Cross  : constant Unsigned_64 :=
        (Left / Half) * (Right mod Half) + Low / Half;
      Cross2 : constant Unsigned_64 :=
        (Left mod Half) * (Right / Half) + Cross mod Half;
   begin
      return (Left / Half) * (Right / Half) + Cross / Half + Cross2 / Half;
   end High_Product;

   function Seeded (Seed : Seed_Number; Path : Direction) return Source is
      Splitter : Source := Source (Seed);
      Value    : Unsigned_64;
   begin
      for Each in Direction'First .. Path loop
         Next (Splitter, Value);
      end loop;
      return Source (Value);
   end Seeded;

   function Seeded (Seed : Seed_Number; Viewer : Observer) return Source is
      Splitter : Source := Seeded (Seed, Direction'Last);
      Value    : Unsigned_64;
   begin
      for Each in Observer'First .. Viewer loop
         Next (Splitter, Value);
      end loop;
      return Source (Value);
   end Seeded;

   procedure Draw (From : in out Source; Value : out Long_Float) is
      Draws : constant := 12;
      Units : Unsigned_64;
      Sum   : Unsigned_64 := 0;
   begin
      for Each in 1 .. Draws loop
         Next (From, Units);
         Sum := Sum + Shift_Right (Units, 12);
      end loop;
      Value := Long_Float (Sum) / 2.0 ** 52 - Long_Float (Draws) / 2.0;
   end Draw;

   function To_Seed (From : Source) return Positive is
     (1 + Positive (From mod 2 ** 30));

   function To_Level (Rate : Faults.Probability) return Level is
      Units : constant Unsigned_64 :=
        (if Rate >= 1.0 then Unsigned_64'Last
         else Unsigned_64
                (Long_Float'Truncation (Long_Float (Rate) * 2.0 ** 64)));
      Made  : Level;
   begin
      Made (1) := Units;
      for N in 2 .. Made'Last loop
         Made (N) := Made (N - 1) + High_Product (-Made (N - 1), Units);
      end loop;
      return (if Units = 0 then (others => 0) else Made);
   end To_Level;

   procedure Draw
     (From : in out Source;
      Rate : Level;
      Mask : out Faults.Character_Bits)
   is
      Value : Unsigned_64;
      First : Positive := 1;
   begin
      Mask := 0;
      Next (From, Value);
      if Value >= Rate (Rate'Last) then
         return;
      end if;

      while Value >= Rate (First) loop
         First := First + 1;
      end loop;
      Mask := 2 ** (First - 1);

      for Further in First + 1 .. Rate'Last loop
         Next (From, Value);
         if Value < Rate (1) then
            Mask := Mask or 2 ** (Further - 1);
         end if;
      end loop;
   end Draw;

end Sim.Noise;
