--  SPDX-License-Identifier: Apache-2.0

--  Decisions of the tasks with one field or condition exchanged.
--  Theorems.Safety needs the claim of the true decision, for which it is
--  proved. It is false for the wrong one.

with URV.Buffers;      use URV.Buffers;
with URV.Codecs;       use URV.Codecs;
with URV.GDCOUT_Steps;
with URV.Handshakes;   use URV.Handshakes;
with URV.LAW_Steps;    use URV.LAW_Steps;
with URV.Laws;         use URV.Laws;
with URV.MDCIN_Steps;
with URV.PWM_Steps;
with URV.Plain_Blocks; use URV.Plain_Blocks;
with URV.Type_Codes;   use URV.Type_Codes;
with URV.Uplink_Input; use URV.Uplink_Input;
with URVOS;            use URVOS;

package Canaries.Steps with SPARK_Mode, Ghost is

   --  TELIN passes on the last message as a new one.
   function As_New
     (Kept : Kept_Message; Result : Outcome; Words : Block_Words)
      return Kept_Message
   is (if Result in URV.Handshakes.Taken
       then (Buffer => Uplink.Buffer_Of (Words), Has_Message => True)
       else Kept)
   with Global => null;

   procedure A_Stored_Message_Is_Old
     (Kept : Kept_Message; Result : Outcome; Words : Block_Words)
   with
     Global => null,
     Pre    => Result not in URV.Handshakes.Taken,
     Post   =>
       Is_Old (Next (Kept, Result, Words).Buffer)
       and then
         Is_Old (As_New (Kept, Result, Words).Buffer);  --  VC_POSTCONDITION

   --  MDCIN passes on a block of another kind in place of the commands.
   function With_Item (Item : Uplink_Buffer; Fresh : Boolean)
                       return Uplink_Buffer
   is (URV.MDCIN_Steps.Passed_On (Item, Fresh, Last => Item))
   with Global => null;

   procedure The_Last_Commands_Are_Given
     (Item  : Uplink_Buffer;
      Fresh : Boolean;
      Last  : Uplink_Buffer;
      Which : Command_Item)
   with
     Global => null,
     Pre    => Is_Other_Kind (Item),
     Post   =>
       URV.MDCIN_Steps.Passed_On (Item, Fresh, Last) (Which) = Last (Which)
       and then With_Item (Item, Fresh) (Which) =  --  VC_POSTCONDITION
         Last (Which);

   --  PWM writes every message of this frame, also an old one.
   function Is_Written_If_Fresh (Item : Uplink_Buffer; Fresh : Boolean)
                                 return Boolean
   is (URV.PWM_Steps.Is_Written (Item, Fresh)
       or else (Fresh and then Is_Old (Item)))
   with Global => null;

   procedure Old_Commands_Are_Not_Written
     (Item : Uplink_Buffer; Fresh : Boolean)
   with
     Global => null,
     Pre    => Is_Old (Item),
     Post   =>
       not URV.PWM_Steps.Is_Written (Item, Fresh)
       and then
         not Is_Written_If_Fresh (Item, Fresh);  --  VC_POSTCONDITION

   --  LAW takes a command that has not come in this frame as new.
   function All_New (Got : Inputs) return Inputs is
     ((Got with delta Has_Commands => True))
   with Global => null;

   procedure The_Stick_Is_Old_When_It_Was
     (Before : Kept; Usual : Settings; Got : Inputs; Result : out Decision)
   with
     Global => null,
     Pre    => Usual.On and then not Got.Has_Commands,
     Post   =>
       Result.Flown.By_Law  --  VC_POSTCONDITION
       or else Is_Old (Result.Flown.Message);

   --  GDCOUT sends an earlier image as a new one.
   procedure An_Image_Of_Before_Is_Old (Image : AD_Image; Bits : Word)
   with
     Global => null,
     Post   =>
       Is_Old
         (URV.GDCOUT_Steps.Message_Of (Image, False, Stick_Codes, Bits))
       and then
         Is_Old  --  VC_POSTCONDITION
           (URV.GDCOUT_Steps.Message_Of (Image, True, Stick_Codes, Bits));

end Canaries.Steps;
