--  SPDX-License-Identifier: Apache-2.0

package body URV.Word_Codecs with SPARK_Mode is

   function Encode (Source : Buffer) return Block_Data is
      Result : Block_Data := (others => 0);
   begin
      for Which in Item loop
         Result (Place (Which)) := High_Byte (Source (Which));
         Result (Place (Which) + 1) := Low_Byte (Source (Which));

         pragma Loop_Invariant
           (for all Earlier in Item'First .. Which =>
              Result (Place (Earlier)) = High_Byte (Source (Earlier))
              and then Result (Place (Earlier) + 1) =
                         Low_Byte (Source (Earlier)));
         pragma Loop_Invariant
           (for all I in Byte_Index =>
              (if I > Block_Length then Result (I) = 0));
      end loop;
      return Result;
   end Encode;

   function Decode (Source : Block_Data) return Buffer is
      Result : Buffer := (others => 0);
   begin
      for Which in Item loop
         Result (Which) :=
           To_Word (Source (Place (Which)), Source (Place (Which) + 1));

         pragma Loop_Invariant
           (for all Earlier in Item'First .. Which =>
              Result (Earlier) =
                To_Word (Source (Place (Earlier)),
                         Source (Place (Earlier) + 1)));
      end loop;
      return Result;
   end Decode;

   procedure Round_Trip (Source : Buffer) is null;

   procedure Round_Trip_Of_Bytes (Source : Block_Data; I : Byte_Index) is
      Which : constant Item :=
        Item'Val (Item'Pos (Item'First) + (Integer (I) - 1) / 2);
   begin
      pragma Assert
        (if I = Place (Which)
         then Source (I) = Source (Place (Which))
         else Source (I) = Source (Place (Which) + 1));
   end Round_Trip_Of_Bytes;

end URV.Word_Codecs;
