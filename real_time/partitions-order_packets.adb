--  SPDX-License-Identifier: Apache-2.0

with URV.Type_Codes; use URV.Type_Codes;

package body Partitions.Order_Packets is

   use type Number;

   Magic   : constant := 16#5552_564F#;
   Version : constant := 1;

   --  The positions of the fields.
   Magic_At    : constant := 1;
   Version_At  : constant := 5;
   Length_At   : constant := 7;
   Run_At      : constant := 9;
   Sequence_At : constant := 13;
   Time_At     : constant := 17;
   Kind_At     : constant := 25;
   Items_At    : constant := 27;

   function Is_Meant (Source : Octet_Array) return Boolean is
     (Source'Length >= 4
      and then Value_At (Source, Source'First, 4) = Magic);

   procedure Read
     (Source   : Octet_Array;
      Item     : out Packet;
      Is_Valid : out Boolean)
   is
      --  From 1 on, so that the places fit.
      subtype Whole is Octet_Array (1 .. Length);

      Place : Positive := Items_At;
      Value : Number;
   begin
      Item := (others => <>);
      Is_Valid := Source'Length = Length;
      if not Is_Valid then
         return;
      end if;

      declare
         Bytes : constant Whole := Source;
      begin
         Is_Valid :=
           Value_At (Bytes, Magic_At, 4) = Magic
           and then Value_At (Bytes, Version_At, 2) = Version
           and then Value_At (Bytes, Length_At, 2) = Length
           and then Value_At (Bytes, Kind_At, 2) =
                      Number (Configuration_Kind);
         Item.Run      := Value_At (Bytes, Run_At, 4);
         Item.Sequence := Value_At (Bytes, Sequence_At, 4);
         Item.Made_At  := Value_At (Bytes, Time_At, 8);
         for Each of Item.Item loop
            Value := Value_At (Bytes, Place, 2);
            Is_Valid := Is_Valid and then Value <= Number (Field'Last);
            Each := Field (Value mod (Number (Field'Last) + 1));
            Place := Place + 2;
         end loop;
         Is_Valid :=
           Is_Valid and then Item.Item (Serial) in Serial_Number;
      end;
   end Read;

end Partitions.Order_Packets;
