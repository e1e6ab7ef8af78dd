--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Arrangements with SPARK_Mode is

   function Initial_Arrangement return Arrangement is
     ((TCBs   => (for Where in Place => TCB_Number (Where)),
       Places => (for Which in TCB_Number => Place (Which))));

   procedure Move (Row : in out Arrangement; From, To : Place) is
      Before : constant Arrangement := Row with Ghost;
      Moved  : constant TCB_Number := Row.TCBs (From);
   begin
      if From < To then
         for Where in From .. To - 1 loop
            Row.TCBs (Where) := Row.TCBs (Where + 1);
            Row.Places (Row.TCBs (Where)) := Where;
            pragma Loop_Invariant
              (for all I in Place =>
                 Row.TCBs (I) =
                   (if I in From .. Where
                    then Before.TCBs (I + 1)
                    else Before.TCBs (I)));
            pragma Loop_Invariant
              (for all Which in TCB_Number =>
                 Row.Places (Which) =
                   (if Before.Places (Which) in From + 1 .. Where + 1
                    then Before.Places (Which) - 1
                    else Before.Places (Which)));
         end loop;
      else
         for Where in reverse To + 1 .. From loop
            Row.TCBs (Where) := Row.TCBs (Where - 1);
            Row.Places (Row.TCBs (Where)) := Where;
            pragma Loop_Invariant
              (for all I in Place =>
                 Row.TCBs (I) =
                   (if I in Where .. From
                    then Before.TCBs (I - 1)
                    else Before.TCBs (I)));
            pragma Loop_Invariant
              (for all Which in TCB_Number =>
                 Row.Places (Which) =
                   (if Before.Places (Which) in Where - 1 .. From - 1
                    then Before.Places (Which) + 1
                    else Before.Places (Which)));
         end loop;
      end if;
      Row.TCBs (To) := Moved;
      Row.Places (Moved) := To;
   end Move;

end URVOS.Arrangements;
