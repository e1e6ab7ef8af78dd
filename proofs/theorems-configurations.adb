--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Configurations with SPARK_Mode is

   procedure The_Sent_Word_Arrives (Source : Configuration) is null;

   procedure One_Wrong_Word_Is_Refused
     (Source : Configuration;
      Where  : Command_Item;
      Value  : Word;
      Set    : Settings;
      Flown  : URV.Laws.Memory)
   is
      Block : constant Uplink_Buffer :=
        (Block_Of (Source) with delta Where => Value);
   begin
      pragma Assert (Is_Other_Kind (Block));
      case Where is
         when Roll =>
            pragma Assert (Kind_Of (Block) = Value);
         when Pitch | Switch_1 =>
            pragma Assert (not Is_Twice (Block (Pitch), Block (Switch_1)));
         when Yaw | Switch_2 =>
            pragma Assert (not Is_Twice (Block (Yaw), Block (Switch_2)));
         when Throttle | Switch_3 =>
            pragma Assert (not Is_Twice (Block (Throttle), Block (Switch_3)));
         when Brake | Switch_4 =>
            pragma Assert (not Is_Twice (Block (Brake), Block (Switch_4)));
         when Switch_5 =>
            pragma Assert
              (if Has_Items (Block)
               then Configuration_Of (Block) = Source);
         when Switch_6 .. Switch_8 =>
            pragma Assert (Block (Where) /= 0);
      end case;
      pragma Assert (not Is_Whole (Block));
      pragma Assert (Answer_To (Block, Set, Flown) = Not_Whole);
   end One_Wrong_Word_Is_Refused;

   procedure A_Refused_One_Changes_Nothing
     (Now   : Setting;
      Block : Uplink_Buffer;
      Set   : Settings;
      Flown : URV.Laws.Memory) is null;

   procedure Times_Stay_In_Range (Set : Settings; Now : Setting) is null;

end Theorems.Configurations;
