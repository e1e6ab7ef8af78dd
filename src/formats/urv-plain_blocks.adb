--  SPDX-License-Identifier: Apache-2.0

package body URV.Plain_Blocks with SPARK_Mode is

   function Encode (Source : Block_Words; Last : Word_Place)
                    return Block_Data
   is
      Result : Block_Data := [others => 0];
   begin
      for Which in Word_Place range 1 .. Last loop
         Result (2 * Which - 1) := High_Byte (Source (Which));
         Result (2 * Which) := Low_Byte (Source (Which));

         pragma Loop_Invariant
           (for all Each in Word_Place =>
              Result (2 * Each - 1) =
                (if Each <= Which then High_Byte (Source (Each)) else 0)
              and then Result (2 * Each) =
                (if Each <= Which then Low_Byte (Source (Each)) else 0));
      end loop;
      return Result;
   end Encode;

   function Decode (Source : Block_Data; Last : Word_Place)
                    return Block_Words
   is
      Result : Block_Words := [others => 0];
   begin
      for Which in Word_Place range 1 .. Last loop
         Result (Which) :=
           To_Word (Source (2 * Which - 1), Source (2 * Which));

         pragma Loop_Invariant
           (for all Each in Word_Place =>
              Result (Each) =
                (if Each <= Which
                 then To_Word (Source (2 * Each - 1), Source (2 * Each))
                 else 0));
      end loop;
      return Result;
   end Decode;

   procedure Round_Trip (Source : Block_Words; Last : Word_Place) is
   begin
      pragma Assert
        (for all Which in Word_Place =>
           (if Which <= Last
            then Decode (Encode (Source, Last), Last) (Which) =
              Source (Which)));
   end Round_Trip;

end URV.Plain_Blocks;
