--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Frame_Packets is

   Magic   : constant := 16#5552_5646#;
   Version : constant := 1;

   --  The rows that a packet has.
   subtype Told_Row is Log_Row_Number range 1 .. 32;

   function To_Packet (Item : Frame) return Packet is
      Result : Packet  := (others => 0);
      Last   : Natural := 0;

      procedure Put (Value : Number; Bytes : Positive);
      procedure Put (Rows : Log_Rows);

      procedure Put (Value : Number; Bytes : Positive) is
      begin
         Append (Result, Last, Value, Bytes);
      end Put;

      procedure Put (Rows : Log_Rows) is
      begin
         for Which in Told_Row loop
            for Word of Rows (Which) loop
               Put (Number (Word), 2);
            end loop;
         end loop;
      end Put;

   begin
      Put (Magic, 4);
      Put (Version, 2);
      Put (Length, 2);
      Put (Item.Run, 4);
      Put (Item.Sequence, 4);
      Put (Item.Time, 8);
      Put (Item.Downlink_Age, 4);
      Put (Item.Console_State, 2);
      Put (Item.Link_State, 2);
      Put (Item.Console_Sequence, 4);
      for Count of Item.Counts loop
         Put (Count, 4);
      end loop;
      for Word of Item.Words loop
         Put (Word, 2);
      end loop;
      Put (Item.Log);
      Put (Item.Aircraft_Log);
      for Word of Item.Status loop
         Put (Number (Word), 2);
      end loop;
      Put (Item.Pilot, 2);
      return Result;
   end To_Packet;

end Partitions.Frame_Packets;
