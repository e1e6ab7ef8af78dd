--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Steps with SPARK_Mode is

   procedure A_Stored_Message_Is_Old
     (Kept : Kept_Message; Result : Outcome; Words : Block_Words)
   is null;

   procedure The_Last_Commands_Are_Given
     (Item  : Uplink_Buffer;
      Fresh : Boolean;
      Last  : Uplink_Buffer;
      Which : Command_Item)
   is null;

   procedure Old_Commands_Are_Not_Written
     (Item : Uplink_Buffer; Fresh : Boolean)
   is null;

   procedure The_Stick_Is_Old_When_It_Was
     (Before : Kept; Usual : Settings; Got : Inputs; Result : out Decision)
   is
      Unused_After : Kept := Before;
   begin
      Decide (Unused_After, Usual, All_New (Got), Result);
   end The_Stick_Is_Old_When_It_Was;

   procedure An_Image_Of_Before_Is_Old (Image : AD_Image; Bits : Word)
   is null;

end Canaries.Steps;
