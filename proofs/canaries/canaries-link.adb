--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Link with SPARK_Mode is

   procedure Headers_Are_Farther_Apart (Left, Right : Byte) is null;

   procedure Two_Steps_Distinguish
     (Left, Right : Byte; Data, Other : Byte) is null;

   procedure Ground_Need_Not_Wait (Item : in out Board) is
   begin
      Elapse (Item, Dead_Space - 1);
   end Ground_Need_Not_Wait;

   procedure Last_Byte_Fills_The_Buffer
     (Item         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Data         : Byte;
      Parity_Error : Boolean;
      Outcome      : out Event)
   is
   begin
      Accept_Character (Item, Pair, 28, True, Data, Parity_Error, Outcome);
   end Last_Byte_Fills_The_Buffer;

   procedure Late_Character_Is_Bad
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
   begin
      Elapse (Item, Guard_Time);
      Accept_Character (Item, Data, Parity_Error);
   end Late_Character_Is_Bad;

   procedure Every_Character_Is_Data
     (Item   : Sender;
      Data   : Block_Data;
      Output : Byte) is null;

   procedure A_Filled_Place_Was_Empty (Pair : Buffer_Pair) is null;

   procedure Nothing_Is_Overwritten
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   is
   begin
      Accept_Character (Item, Data, Parity_Error);
   end Nothing_Is_Overwritten;

end Canaries.Link;
