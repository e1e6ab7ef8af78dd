--  SPDX-License-Identifier: Apache-2.0

--  Test inputs move servos, sticks and the laws' commands only while a card
--  runs that a scan has started, within its amplitude and rate, and end with
--  it (FTI-1, FTI-3, FTI-4, FTI-5). This holds for any cards, memory, sensors,
--  commands and states of the link.

with URV.Buffers;       use URV.Buffers;
with URV.Card_Blocks;   use URV.Card_Blocks;
with URV.Law_Inputs;    use URV.Law_Inputs;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Test_Cards;    use URV.Test_Cards;
with URV.Test_Envelopes; use URV.Test_Envelopes;
with URV.Test_Inputs;   use URV.Test_Inputs;
with URV.Test_Runs;     use URV.Test_Runs;
with URVOS;             use URVOS;

package Theorems.Test_Cards with SPARK_Mode, Ghost is

   --  The aircraft decodes the card that the ground has encoded, in words of
   --  12 bits.
   procedure What_Is_Sent_Comes (Source : Card)
   with
     Global => null,
     Post   =>
       Is_Whole (Block_Of (Source))
       and then Card_Of (Block_Of (Source)) = Source
       and then
         (for all Place in Command_Item =>
            Block_Of (Source) (Place) in Converter_Value);

   --  A block with one wrong word is refused, and changes nothing.
   procedure One_Wrong_Word_Is_Refused
     (Source : Card;
      Where  : Command_Item;
      Value  : Word;
      Before : Aboard;
      On     : Boolean)
   with
     Global => null,
     Pre    => Value /= Block_Of (Source) (Where),
     Post   =>
       Answer_To
         ((Block_Of (Source) with delta Where => Value), Before, On) =
           Not_Whole;

   --  A card that is taken can run, or clears its slot.
   procedure Taken_Cards_Are_In_Range
     (Block : Uplink_Buffer; Before : Aboard; On : Boolean)
   with
     Global => null,
     Pre    =>
       (for all Which in Slot =>
          Before.Deck (Which) = Empty_Card
          or else Is_Loaded (Before.Deck (Which))),
     Post   =>
       (for all Which in Slot =>
          After_Block (Block, Before, On).Deck (Which) = Empty_Card
          or else Is_Loaded (After_Block (Block, Before, On).Deck (Which)));

   --  The inputs of a frame.
   type Frame_Number is range 1 .. 100_000;
   type History is array (Frame_Number) of Situation;

   --  If something is added after any history from the start on, a card was
   --  started: in that frame new commands had switch 5 on, the commands before
   --  had it off, and the aircraft was linked and not disconnected.
   procedure A_Scan_Has_Started_It
     (Deck    : Card_Deck;
      Frames  : History;
      Upto    : Frame_Number;
      After   : out Run;
      Started : out Boolean;
      Since   : out Frame_Number)
   with
     Global => null,
     Post   =>
       (if After.Added /= Nothing_Added or else After.Running > 0
        then Started)
       and then
         (if Started
          then Since <= Upto
            and then Frames (Since).Is_New
            and then Is_On (Frames (Since).Heard (Switch_5))
            and then Frames (Since).Is_Linked
            and then not Frames (Since).Is_Cut);

   --  With no loaded card nothing starts, whatever the memory; without a
   --  running card, and nothing added, the words of servos and sticks do not
   --  change, nor do the laws' commands.
   procedure Without_Cards_Nothing_Changes
     (This     : Run;
      Sight    : Situation;
      Servos   : PWM_Buffer;
      Commands : Uplink_Buffer)
   with
     Global => null,
     Pre    =>
       (for all Item in Servo_Item => Servos (Item) in Converter_Value),
     Post   =>
       Next (This, No_Cards, Sight).Running = 0
       and then
         (if This.Added = Nothing_Added
          then Next (This, No_Cards, Sight).Added = Nothing_Added
            and then
              With_Inputs (Servos, Next (This, No_Cards, Sight).Added) =
                Servos
            and then
              (for all Name in Command_Item =>
                 With_Sticks
                   (Commands, To_Sticks (Next (This, No_Cards, Sight))) (Name)
                 = Commands (Name))
            and then
              To_Commands (Next (This, No_Cards, Sight)) = No_Commands);

   --  The inputs are added at one place: the card's, until they are 0.
   procedure Each_Input_Has_One_Place
     (This : Run; Deck : Card_Deck; Sight : Situation)
   with
     Global => null,
     Post   =>
       (case Next (This, Deck, Sight).Place is
           when At_Servo   =>
             To_Sticks (Next (This, Deck, Sight)) = No_Sticks
             and then To_Commands (Next (This, Deck, Sight)) = No_Commands,
           when At_Stick   =>
             To_Servos (Next (This, Deck, Sight)) = Nothing_Added
             and then To_Commands (Next (This, Deck, Sight)) = No_Commands,
           when At_Command =>
             To_Servos (Next (This, Deck, Sight)) = Nothing_Added
             and then To_Sticks (Next (This, Deck, Sight)) = No_Sticks)
       and then
         (if This.Added /= Nothing_Added
          then Next (This, Deck, Sight).Place = This.Place)
       and then
         (if Next (This, Deck, Sight).Running > 0
          then Next (This, Deck, Sight).Place =
            Place_Of (Deck (Next (This, Deck, Sight).Running)));

   --  A card ends in the frame of each of these events.
   procedure It_Ends_In_One_Frame
     (This : Run; Deck : Card_Deck; Sight : Situation)
   with
     Global => null,
     Pre    =>
       This.Running > 0
       and then
         (Sight.Is_Cut
          or else not Sight.Is_Linked
          or else not Is_On (Sight.Heard (Switch_5))
          or else Sight.Failed
          or else not Are_Resting (This, Sight.Heard)
          or else not Has_Sensors (Deck (This.Running), Sight.Checks)
          or else not Is_Inside (Deck (This.Running), Sight.Checks)
          or else not Is_Followed (Deck (This.Running), Sight.Flown)
          or else not Is_Ready (Deck, This.Running)
          or else This.Frame >= Length_Of (Deck (This.Running)) - 1),
     Post   => Next (This, Deck, Sight).Running = 0;

   --  After its end an input is 0 at the latest after the frames in which its
   --  rate limit covers the amplitude, whatever comes.
   Last_Frames : constant := 16;

   procedure Inputs_Return_To_0
     (This   : Run;
      Deck   : Card_Deck;
      Frames : History;
      Which  : Test_Surface;
      After  : out Run;
      Is_Run : out Boolean)
   with
     Global => null,
     Post   => (if not Is_Run then After.Added (Which) = 0);

end Theorems.Test_Cards;
