--  SPDX-License-Identifier: Apache-2.0

--  A configuration from the ground takes effect as a whole or not at all
--  (EXT-2, D-26). The aircraft refuses every configuration with one wrong
--  word, with a value out of range, or during flight by a law; a refused one
--  changes nothing. This holds for all settings and states of the laws. Blocks
--  with several wrong words are not covered. Theorems.Safety shows that a
--  configuration moves no servo by itself.

with URV.Buffers;        use URV.Buffers;
with URV.Configurations; use URV.Configurations;
with URV.Frame_Times;    use URV.Frame_Times;
with URV.Law_Gains;      use URV.Law_Gains;
with URV.Laws;           use URV.Laws;
with URV.Link_Loss;      use URV.Link_Loss;
with URV.Type_Codes;     use URV.Type_Codes;
with URVOS;              use URVOS;

package Theorems.Configurations with SPARK_Mode, Ghost is

   --  The aircraft decodes the configuration that the ground has encoded, in
   --  words of 12 bits.
   procedure The_Sent_Word_Arrives (Source : Configuration)
   with
     Global => null,
     Post   =>
       Is_Whole (Block_Of (Source))
       and then Configuration_Of (Block_Of (Source)) = Source
       and then Is_Other_Kind (Block_Of (Source))
       and then
         (for all Place in Command_Item =>
            Block_Of (Source) (Place) in Converter_Value);

   --  A block with one altered word is no valid configuration.
   procedure One_Wrong_Word_Is_Refused
     (Source : Configuration;
      Where  : Command_Item;
      Value  : Word;
      Set    : Settings;
      Flown  : URV.Laws.Memory)
   with
     Global => null,
     Pre    => Value /= Block_Of (Source) (Where),
     Post   =>
       Answer_To ((Block_Of (Source) with delta Where => Value), Set, Flown)
         = Not_Whole;

   --  A refused configuration changes nothing. All are refused while a law
   --  flies.
   procedure A_Refused_One_Changes_Nothing
     (Now   : Setting;
      Block : Uplink_Buffer;
      Set   : Settings;
      Flown : URV.Laws.Memory)
   with
     Global => null,
     Post   =>
       (if Answer_To (Block, Set, Flown) in Refused
        then After (Now, Block, Set, Flown) = Now)
       and then
         (if Flown.Is_Flying and then Flown.Flown /= All_Direct
          then Answer_To (Block, Set, Flown) in Refused)
       and then
         (if Flown.Is_Flying and then not Is_All_Stick (Flown)
          then Answer_To (Block, Set, Flown) in Refused);

   --  After any configuration the times are in range, and the laws are on or
   --  off as the node is set.
   procedure Times_Stay_In_Range (Set : Settings; Now : Setting)
   with
     Global => null,
     Post   =>
       In_Force (Set, Now).On = Set.On
       and then
         (if Now.Is_Set
          then In_Force (Set, Now).By.Hold = Hold_After
            and then In_Force (Set, Now).By.Orbit in
                       Frames_Per_Second .. 60 * Frames_Per_Second
            and then In_Force (Set, Now).By.Terminate_At in
                       2 * Frames_Per_Second .. 300 * Frames_Per_Second);

end Theorems.Configurations;
