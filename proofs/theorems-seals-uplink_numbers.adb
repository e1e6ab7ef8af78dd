--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Seals.Uplink_Numbers with SPARK_Mode is

   procedure The_Latest_Is_It (Number, Modulus, Most : Counter) is
      Of_Number : constant Counter := Number / Modulus;
      Of_Most   : constant Counter := Most / Modulus;
   begin
      pragma Assert (Number = Modulus * Of_Number + Number mod Modulus);
      pragma Assert (Most = Modulus * Of_Most + Most mod Modulus);
      pragma Assert (Of_Number <= Of_Most);
      pragma Assert
        (if Of_Most > Of_Number + 1
         then Modulus * Of_Most >= Modulus * Of_Number + 2 * Modulus);
      pragma Assert (Of_Most in Of_Number .. Of_Number + 1);
      pragma Assert
        (if Of_Most = Of_Number + 1
         then Modulus * Of_Most = Modulus * Of_Number + Modulus);
   end The_Latest_Is_It;

   --  Two values of six bits share a field.
   procedure Halves_Of_A_Field (High, Low : Word)
   with
     Global => null,
     Pre    => High < Number_Modulus and then Low < Number_Modulus,
     Post   =>
       (High * Number_Modulus + Low) / Number_Modulus = High
       and then (High * Number_Modulus + Low) mod Number_Modulus = Low;

   procedure Halves_Of_A_Field (High, Low : Word) is null;

   procedure Uplink_Determines
     (Block  : Block_Data;
      Number : Counter;
      Echo   : Counter;
      Theirs : Session)
   is
      Last : constant Field := Field_At (Block, Uplink_Words);
   begin
      Halves_Of_A_Field (Word (Number mod Number_Modulus), Code_Of (Echo));
      pragma Assert
        (Counter (Last / Number_Modulus) = Number mod Number_Modulus);
      pragma Assert (Last mod Number_Modulus = Code_Of (Echo));
      The_Latest_Is_It (Number, Number_Modulus, Latest (Theirs));
      pragma Assert (Uplink_Number (Block, Latest (Theirs)) = Number);
      if Echo > 0 then
         The_Latest_Is_It (Echo, Echo_Modulus, Theirs.Age);
      end if;
   end Uplink_Determines;

end Theorems.Seals.Uplink_Numbers;
