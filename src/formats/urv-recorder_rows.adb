--  SPDX-License-Identifier: Apache-2.0

package body URV.Recorder_Rows with SPARK_Mode is

   function Row_Of (Number : Row_Number; Words : Recorded_Words) return Row is
      Sum      : Word := 0;
      Partials : Word := 0;
   begin
      for Place in Content_Word loop
         Sum := Sum + Content_Of (Number, Words, Place);
         Partials := Partials + Sum;
         pragma Assert
           (Partials_Up_To (Number, Words, Place) =
              (if Place = 1 then 0
               else Partials_Up_To (Number, Words, Place - 1))
              + Sum_Up_To (Number, Words, Place));
         pragma Loop_Invariant (Sum = Sum_Up_To (Number, Words, Place));
         pragma Loop_Invariant
           (Partials = Partials_Up_To (Number, Words, Place));
      end loop;
      return (Number, Words, Sum, Partials);
   end Row_Of;

end URV.Recorder_Rows;
