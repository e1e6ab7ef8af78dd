--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Log_Pieces with SPARK_Mode is

   --  A high and a low byte make the word again.
   procedure Bytes_Make_The_Word (Value : Word)
   with
     Global => null,
     Post   =>
       ((Value / 256 * 256 and 16#FF00#) or Value mod 256) = Value;

   procedure Bytes_Make_The_Word (Value : Word) is null;

   procedure A_Row_Arrives
     (Item  : in out Receiver;
      Which : Log_Row_Number;
      Row   : Log_Row;
      Whole : out Boolean)
   is
      Unused_Whole : Boolean;
   begin
      Take (Item, Piece_At (Which, Row, 1), Unused_Whole);
      for Where in Place range 2 .. Place'Last loop
         pragma Loop_Invariant
           (Item.Got = Where - 1
            and then Item.Which = Which);
         pragma Loop_Invariant
           (for all Field in Log_Field =>
              (if 2 * Log_Field'Pos (Field) + 3 < Integer (Where)
               then Item.Row (Field) = Row (Field)));
         pragma Loop_Invariant
           (if not Is_High (Where)
            then Item.Row (Field_At (Where)) =
              Row (Field_At (Where)) / 256 * 256);

         pragma Assert
           (Piece_At (Which, Row, Where) mod 256 =
              Byte_At (Which, Row, Where));
         Take (Item, Piece_At (Which, Row, Where), Whole);
         Bytes_Make_The_Word (Row (Field_At (Where)));
         pragma Assert
           (if not Is_High (Where)
            then Item.Row (Field_At (Where)) = Row (Field_At (Where)));
      end loop;
   end A_Row_Arrives;

   procedure A_Gap_Leaves_Another_Place
     (Item : Receiver; Missed : Place; Next : Piece) is null;

   procedure Silence_Ends_A_Row (Item : in out Receiver) is
   begin
      for Frame in 1 .. Most_Silent + 1 loop
         Item := After_Silence (Item);
         pragma Loop_Invariant
           (Item.Got = 0 or else Integer (Item.Silent) >= Frame);
      end loop;
   end Silence_Ends_A_Row;

   procedure A_Piece_Beside_The_Flags (Status : Word; Item : Piece) is null;

end Theorems.Log_Pieces;
