--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Arrangements with SPARK_Mode is

   type Place_Table is array (TCB_Number) of Place with Ghost;

   --  Who stands somewhere is found.
   procedure Prove_Found (Row : Arrangement; Places : Place_Table)
   with
     Ghost,
     Global => null,
     Pre    => (for all Which in TCB_Number => Row (Places (Which)) = Which),
     Post   =>
       (for all Which in TCB_Number => Row (Place_Of (Row, Which)) = Which);

   function Found (Row : Arrangement; Which : TCB_Number) return Place is
      pragma Assertion_Policy (Loop_Invariant => Ignore);
   begin
      for Where in Place range 1 .. Place'Last - 1 loop
         if Row (Where) = Which then
            return Where;
         end if;
         pragma Loop_Invariant
           (for all Passed in 1 .. Where => Row (Passed) /= Which);
      end loop;
      return Place'Last;
   end Found;

   procedure Prove_Found (Row : Arrangement; Places : Place_Table) is
   begin
      for Which in TCB_Number loop
         pragma Assert (Row (Places (Which)) = Which);
         pragma Loop_Invariant
           (for all Found in 1 .. Which =>
              Row (Place_Of (Row, Found)) = Found);
      end loop;
   end Prove_Found;

   function Initial_Arrangement return Arrangement is
      Row : constant Arrangement :=
        (for Where in Place => TCB_Number (Where));
   begin
      Prove_Found (Row, (for Which in TCB_Number => Place (Which)));
      return Row;
   end Initial_Arrangement;

   procedure Move (Row : in out Arrangement; From, To : Place) is
      Before : constant Arrangement := Row with Ghost;
      Moved  : constant TCB_Number := Row (From);
   begin
      if From < To then
         Row (From .. To - 1) := Row (From + 1 .. To);
         pragma Assert
           (for all Where in Place =>
              Row (Where) =
                Before (if Where in From .. To - 1 then Where + 1
                        else Where));
      elsif To < From then
         Row (To + 1 .. From) := Row (To .. From - 1);
         pragma Assert
           (for all Where in Place =>
              Row (Where) =
                Before (if Where in To + 1 .. From then Where - 1
                        else Where));
      end if;
      pragma Assert
        (for all Where in Place =>
           (if Where /= To
            then Row (Where) = Before (Place_After_Move (Where, To, From))));
      Row (To) := Moved;

      --  Who is at a place came from one, and each is where it was moved to.
      pragma Assert
        (for all Where in Place =>
           Row (Where) = Before (Place_After_Move (Where, To, From)));
      pragma Assert
        (for all Where in Place =>
           Row (Place_After_Move (Where, From, To)) = Before (Where));
      Prove_Found
        (Row,
         (for Which in TCB_Number =>
            Place_After_Move (Place_Of (Before, Which), From, To)));
      pragma Assert
        (for all Where in Place =>
           Place_Of (Before, Row (Where))
           = Place_After_Move (Where, To, From));
   end Move;

end URVOS.Arrangements;
