--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Frame_Packets is

   Magic : constant := 16#5552_5646#;

   function To_Packet
     (Item : Frame; Version : Version_Number) return Packet
   is
      Result : Packet  := (others => 0);
      Last   : Natural := 0;

      procedure Put (Value : Number; Bytes : Positive);
      procedure Put (Rows : Log_Rows; First, Final : Log_Row_Number);

      procedure Put (Value : Number; Bytes : Positive) is
      begin
         Append (Result, Last, Value, Bytes);
      end Put;

      procedure Put (Rows : Log_Rows; First, Final : Log_Row_Number) is
      begin
         for Which in First .. Final loop
            for Word of Rows (Which) loop
               Put (Number (Word), 2);
            end loop;
         end loop;
      end Put;

   begin
      Put (Magic, 4);
      Put (Number (Version), 2);
      Put (Number (Length (Version)), 2);
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
      Put (Item.Log, First_Row'First, First_Row'Last);
      Put (Item.Aircraft_Log, First_Row'First, First_Row'Last);
      for Word of Item.Status loop
         Put (Number (Word), 2);
      end loop;
      Put (Item.Pilot, 2);
      if Version > 1 then
         Put (Item.Log, Added_Row'First, Added_Row'Last);
         Put (Item.Aircraft_Log, Added_Row'First, Added_Row'Last);
      end if;
      if Version > 2 then
         for Word of Item.Downlink_Frame loop
            Put (Number (Word), 2);
         end loop;
      end if;
      return Result;
   end To_Packet;

end Partitions.Frame_Packets;
