--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Loops with SPARK_Mode is

   function Largest_Of (Source : Row) return Byte is
      Result : Byte := 0;
   begin
      for I in Place loop
         pragma Loop_Invariant
           (for some Earlier  --  VC_LOOP_INVARIANT_INIT
              in Place'First .. I => Result = Source (Earlier));
         Result := Byte'Max (Result, Source (I));
      end loop;
      return Result;
   end Largest_Of;

   function Sum_Of (Source : Row) return Byte is
      Result : Byte := 0;
   begin
      for I in Place loop
         Result := Result + Source (I);
         pragma Loop_Invariant
           (Result >= Source (1));  --  VC_LOOP_INVARIANT_PRESERV
      end loop;
      return Result;
   end Sum_Of;

   function Halvings (Value : Byte) return Word is
      Rest   : Byte := Value;
      Result : Word := 0;
   begin
      while Rest /= 1 loop
         pragma Loop_Variant (Decreases => Rest);  --  VC_LOOP_VARIANT
         Rest := Rest / 2;
         Result := Result + 1;
      end loop;
      return Result;
   end Halvings;

   function Index_Of (Source : Row; Wanted : Byte) return Place is
   begin
      for I in Place loop
         if Source (I) = Wanted then
            return I;
         end if;
         pragma Loop_Invariant
           (for some Earlier in Place'First .. I =>
              Source (Earlier) /= Wanted);
      end loop;
      return Place'Last;
   end Index_Of;

end Canaries.Loops;
