--  SPDX-License-Identifier: Apache-2.0

with URV.Buffers; use URV.Buffers;
with URVOS;       use URVOS;

package body Partitions.Console_Packets is

   use type Octets.Number;

   Magic   : constant := 16#5552_5643#;
   Version : constant := 1;

   --  The positions of the fields.
   Magic_At    : constant := 1;
   Version_At  : constant := 5;
   Length_At   : constant := 7;
   Run_At      : constant := 9;
   Sequence_At : constant := 13;
   Time_At     : constant := 17;
   Words_At    : constant := 25;
   Flags_At    : constant := 51;

   Pilot_Flag : constant := 1;

   procedure Read
     (Source   : Octet_Array;
      Item     : out Packet;
      Is_Valid : out Boolean)
   is
      --  From 1 on, so that the places fit.
      subtype Whole is Octet_Array (1 .. Length);

      Place : Positive := Words_At;
      Value : Number;
   begin
      Item := (others => <>);
      Is_Valid := Source'Length = Length;
      if not Is_Valid then
         return;
      end if;

      declare
         Bytes : constant Whole  := Source;
         Flags : constant Number := Value_At (Bytes, Flags_At, 2);
      begin
         Is_Valid :=
           Value_At (Bytes, Magic_At, 4) = Magic
           and then Value_At (Bytes, Version_At, 2) = Version
           and then Value_At (Bytes, Length_At, 2) = Length
           and then Flags <= Pilot_Flag;
         Item.Run         := Value_At (Bytes, Run_At, 4);
         Item.Sequence    := Value_At (Bytes, Sequence_At, 4);
         Item.Made_At     := Value_At (Bytes, Time_At, 8);
         Item.Pilot_Flies := Flags = Pilot_Flag;
         for Command of Item.Words loop
            Value := Value_At (Bytes, Place, 2);
            Is_Valid :=
              Is_Valid and then Value <= Number (Converter_Value'Last);
            Command := Word (Value);
            Place := Place + 2;
         end loop;
      end;
   end Read;

end Partitions.Console_Packets;
