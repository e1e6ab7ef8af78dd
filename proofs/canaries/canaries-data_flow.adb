--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Data_Flow
  with
    SPARK_Mode,
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

end Canaries.Data_Flow;
