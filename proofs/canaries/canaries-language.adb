--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Language with SPARK_Mode is

   package body Run_Time_Checks is

      procedure Take (Source : Row; Target : out Short_Row) is
      begin
         Target := Source;  --  VC_LENGTH_CHECK
      end Take;

   end Run_Time_Checks;

   package body Contracts is

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

   end Contracts;

   package body Loops is

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

   end Loops;

   package body Data_Flow
     with
       Refined_State => (Memory => (Stored, Looks))
   is

      Stored : Word := 0;
      Looks  : Word := 0;

      procedure Read (Wanted : Boolean; Value : out Word)
      with Refined_Global => (Input => Stored)
      is
         Result : Word;
      begin
         if Wanted then
            Result := Stored;
         end if;
         Value := Result;  --  UNINITIALIZED
      end Read;

      procedure Peek (Value : out Word)
      is
      begin
         Looks := Looks + 1;
         Value := Stored;
      end Peek;

      procedure Sort (Left, Right : Word; Low, High : out Word) is
      begin
         Low := Word'Min (Left, Right);
         High := Word'Max (Left, Right);
      end Sort;

      procedure Add_Up (Left, Right : Word; First, Last : out Word) is
      begin
         First := Left;
         Last := Left + Right;
      end Add_Up;

      procedure Swap (Left, Right : in out Word) is
         Before : constant Word := Left;
      begin
         Left := Right;
         Right := Before;
      end Swap;

      procedure Exchange (Words : in out Row; From, To : Byte) is
      begin
         Swap (Words (From), Words (To));  --  ALIASING
      end Exchange;

      function Is_Empty return Boolean is (Stored = 0)
      with Refined_Global => Stored;

      procedure Fill (Value : Word)
      with
        Refined_Global => (Output => Stored),
        Refined_Post   => Stored >= 1  --  VC_REFINED_POST
      is
      begin
         Stored := Value;
      end Fill;

   end Data_Flow;

end Canaries.Language;
