--  SPDX-License-Identifier: Apache-2.0

package body URV.Word_Codecs with SPARK_Mode is

   function Words_Of (Source : Buffer) return Block_Words is
      Result : Block_Words := [others => 0];
   begin
      for Which in 1 .. Words loop
         Result (Which) := Source (Item_At (Which));

         pragma Loop_Invariant
           (for all Each in Word_Place =>
              Result (Each) =
                (if Each <= Which then Source (Item_At (Each)) else 0));
      end loop;
      return Result;
   end Words_Of;

   function Buffer_Of (Source : Block_Words) return Buffer is
      Result : Buffer := [others => 0];
   begin
      for Which in Item loop
         Result (Which) := Source (Place (Which));

         pragma Loop_Invariant
           (for all Each in Item'First .. Which =>
              Result (Each) = Source (Place (Each)));
      end loop;
      return Result;
   end Buffer_Of;

   procedure Round_Trip (Source : Buffer) is
   begin
      Round_Trip (Words_Of (Source), Words);
      pragma Assert
        (for all Which in Item =>
           Words_Of (Source) (Place (Which)) = Source (Which));
   end Round_Trip;

end URV.Word_Codecs;
