--  SPDX-License-Identifier: Apache-2.0

with URV.Seals; use URV.Seals;

package body URV.Shared_Seals with SPARK_Mode is

   protected body Shared_Seal is

      procedure Configure
        (Format : Format_Number;
         Keys   : Key_List;
         Start  : Nonce) is
      begin
         Seals.Configure (Item, Format, Keys, Start);
      end Configure;

      procedure Restart is
      begin
         Seals.Restart (Item);
      end Restart;

      procedure Set_Time (Now : Clock_Tick) is
      begin
         --  In format 1 no session grows older.
         if Item.Format /= 1 then
            Pass (Item, Frames_Between (Seen, Now));
         end if;
         Seen := Now;
      end Set_Time;

      procedure Open
        (Block   : Block_Data;
         Arrived : Boolean;
         Words   : out Block_Words;
         Result  : out Outcome) is
      begin
         Seals.Open (Item, Block, Arrived, Words, Result);
      end Open;

      procedure Close (Data : Block_Words; Block : out Block_Data) is
      begin
         Seals.Close (Item, Data, Block);
      end Close;

   end Shared_Seal;

end URV.Shared_Seals;
