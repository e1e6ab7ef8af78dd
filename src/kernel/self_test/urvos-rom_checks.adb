--  SPDX-License-Identifier: Apache-2.0

package body URVOS.ROM_Checks with SPARK_Mode is

   procedure Take_Byte
     (Item    : in out Check;
      Data    : Byte;
      Outcome : out Outcome_Kind)
   is
   begin
      Item.Register := Next (Item.Register, Data);

      if Item.Position < Last then
         Item.Position := Item.Position + 1;
         Outcome := Under_Way;
      else
         if Item.Register = Good_Image then
            Item.Good_Passes := Incremented (Item.Good_Passes);
            Outcome := Found_Good;
         else
            Item.Bad_Passes := Incremented (Item.Bad_Passes);
            Outcome := Found_Bad;
         end if;
         Item.Position := 0;
         Item.Register := First_Value;
      end if;
   end Take_Byte;

end URVOS.ROM_Checks;
