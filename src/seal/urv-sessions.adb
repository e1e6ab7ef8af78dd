--  SPDX-License-Identifier: Apache-2.0

package body URV.Sessions with SPARK_Mode is

   function Derivation
     (For_Use        : Use_Of_Key;
      Half           : Byte;
      Ground_Nonce   : Nonce;
      Aircraft_Nonce : Nonce) return Message
   is
      Result : Message := (Length => 18, Bytes => [others => 0]);
   begin
      Result.Bytes (1) := Byte (Use_Of_Key'Pos (For_Use));
      Result.Bytes (2) := Half;
      for Where in Byte_Index range 1 .. 8 loop
         Result.Bytes (Message_Index (Where + 2)) :=
           Byte_Of (Ground_Nonce, Where);
         Result.Bytes (Message_Index (Where + 10)) :=
           Byte_Of (Aircraft_Nonce, Where);

         pragma Loop_Invariant
           (for all Done in Message_Index range 3 .. 10 =>
              (if Byte_Index (Done - 2) <= Where
               then Result.Bytes (Done) =
                      Byte_Of (Ground_Nonce, Byte_Index (Done - 2))));
         pragma Loop_Invariant
           (for all Done in Message_Index range 11 .. 18 =>
              (if Byte_Index (Done - 10) <= Where
               then Result.Bytes (Done) =
                      Byte_Of (Aircraft_Nonce, Byte_Index (Done - 10))));
         pragma Loop_Invariant
           (for all Else_Where in Message_Index =>
              (if Else_Where in 1 .. 2 | 19 .. Message_Index'Last
               then Result.Bytes (Else_Where) =
                      Result.Bytes'Loop_Entry (Else_Where)));
      end loop;
      return Result;
   end Derivation;

end URV.Sessions;
