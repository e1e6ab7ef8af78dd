--  SPDX-License-Identifier: Apache-2.0

--  When test cards run, and what they add in each frame to the servos' words,
--  to the sticks, or to the laws' commands (FTI-1, FTI-4, FTI-5).
--
--     After := Next (Before, Deck, Sight);
--
--  A card starts when switch 5 goes on in new commands, and never otherwise.
--  It ends at its length, or in the frame in which a condition of Verdict is
--  no longer met. The inputs then return to 0 by Rate_Step a frame, after the
--  pilot's disconnect at once.

with URV.Buffers;       use URV.Buffers;
with URV.Card_Blocks;   use URV.Card_Blocks;
with URV.Law_Inputs;
use type URV.Law_Inputs.Stick_Inputs;
use type URV.Law_Inputs.Command_Inputs;
with URV.Law_Units;     use URV.Law_Units;
with URV.Laws;          use URV.Laws;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Sensor_Checks; use URV.Sensor_Checks;
with URV.Test_Cards;    use URV.Test_Cards;
with URV.Test_Envelopes; use URV.Test_Envelopes;
with URV.Test_Inputs;   use URV.Test_Inputs;

package URV.Test_Runs with Pure, SPARK_Mode is

   --  The cards aboard.
   type Card_Deck is array (Slot) of Card;

   No_Cards : constant Card_Deck := (others => (others => 0));

   --  A card's state, or the reason of its end. Well: it may run.
   type Verdict is
     (Well,            --  it runs, or none has run
      Complete,        --  its length is over
      Switched_Off,    --  switch 5 is off
      Disconnected,    --  laws disconnect, or no commands yet
      Link_Lost,       --  the link is not there
      Stick_Moved,     --  a stick is beyond its threshold
      Sensor_Invalid,  --  a sensor that the card needs is not valid
      Envelope_Left,   --  a limit of the card is exceeded
      Surface_Failed,  --  a surface does not follow its servo
      Restarted,       --  a warm start
      Not_Loaded,      --  the chosen slot is empty
      Not_Followed,    --  no law has the command, or none follows the stick
      Inputs_Remain);  --  inputs of the last card are still on another place

   --  A stick beyond this distance from its position at the card's start ends
   --  the card: 10 % of its travel.
   Stick_Limit : constant := 200;

   type Run is record
      --  The slot of the next card, and of the running one.
      Chosen  : Slot_Or_None := 0;
      Running : Slot_Or_None := 0;

      --  The frame of the running card, from 0, and its phase.
      Frame   : Frame_Count  := 0;
      Phase   : Phase_Number := 0;

      --  Switch 5 was on in the last new commands. True at the start, so that
      --  a switch that was left on starts no card.
      Was_On  : Boolean := True;

      --  The sticks at the card's start.
      Roll_Rest, Pitch_Rest, Yaw_Rest : Demand := 0;

      --  The last card that ran, or should have run, and the reason of its
      --  end.
      Last_Run : Slot_Or_None := 0;
      Reason   : Verdict := Well;

      --  The inputs of this frame, and the place where they are added.
      Place : Input_Place := At_Servo;
      Added : Increments := (others => 0);
   end record;

   function Is_Running (This : Run) return Boolean is (This.Running > 0)
   with Global => null;

   --  All that the aircraft keeps of test cards.
   type Aboard is record
      Deck : Card_Deck;
      Run  : Test_Runs.Run;
   end record;

   function Nothing_Aboard return Aboard is
     ((Deck => No_Cards, Run => (others => <>)))
   with Global => null;

   --  The facts of a frame on which a card depends. Heard: the last commands
   --  that were not marked as old; Is_New: they are of this frame. Is_Cut: the
   --  pilot's disconnect, or no commands yet. Is_Linked: the link is there.
   --  Failed: a surface has failed. Flown: the modes of the laws.
   type Situation is record
      Heard     : Uplink_Buffer;
      Is_New    : Boolean;
      Is_Cut    : Boolean;
      Is_Linked : Boolean;
      Failed    : Boolean;
      Flown     : Modes;
      Checks    : Check_Table;
   end record;

   --  The card of a slot

   function Is_Ready (Deck : Card_Deck; Which : Slot_Or_None) return Boolean
   is
     (Which > 0 and then Is_Loaded (Deck (Which)))
   with Global => null;

   --  The pilot's own sticks are near their positions at the card's start. A
   --  card's inputs to them do not count.
   function Are_Resting (This : Run; Heard : Uplink_Buffer) return Boolean is
     (abs (Demand_Of (Heard (Roll)) - This.Roll_Rest) <= Stick_Limit
      and then abs (Demand_Of (Heard (Pitch)) - This.Pitch_Rest) <=
                 Stick_Limit
      and then abs (Demand_Of (Heard (Yaw)) - This.Yaw_Rest) <= Stick_Limit)
   with Global => null;

   --  Whether a card may run in this frame; its length is not considered.
   function Judged (Source : Card; Sight : Situation) return Verdict is
     (if Sight.Is_Cut then Disconnected
      elsif not Sight.Is_Linked then Link_Lost
      elsif not Is_On (Sight.Heard (Switch_5)) then Switched_Off
      elsif Sight.Failed then Surface_Failed
      elsif not Has_Sensors (Source, Sight.Checks) then Sensor_Invalid
      elsif not Is_Inside (Source, Sight.Checks) then Envelope_Left
      elsif not Is_Followed (Source, Sight.Flown) then Not_Followed
      else Well)
   with Global => null;

   --  Switch 5 goes on in new commands, and a card is chosen.

   function Is_Started
     (This : Run; Heard : Uplink_Buffer; Is_New : Boolean) return Boolean
   is
     (Is_New
      and then Is_On (Heard (Switch_5))
      and then not This.Was_On
      and then This.Chosen > 0)
   with Global => null;

   function Is_Started (This : Run; Sight : Situation) return Boolean is
     (Is_Started (This, Sight.Heard, Sight.Is_New))
   with Global => null;

   --  The next loaded slot after a slot, from the first again after the last;
   --  0 if there is none.
   function Next_Loaded (Deck : Card_Deck; From : Slot_Or_None)
                         return Slot_Or_None
   with
     Global => null,
     Post   =>
       (if Next_Loaded'Result > 0
        then Is_Loaded (Deck (Next_Loaded'Result)));

   --  The inputs of this frame, by their place.

   function To_Servos (This : Run) return Increments is
     (if This.Place = At_Servo then This.Added else Nothing_Added)
   with Global => null;

   function To_Sticks (This : Run) return Law_Inputs.Stick_Inputs is
     (if This.Place = At_Stick
      then
        (Roll  => This.Added (Left_Aileron),
         Pitch => This.Added (Left_Elevator),
         Yaw   => This.Added (Left_Rudder))
      else Law_Inputs.No_Sticks)
   with
     Global => null,
     Post   =>
       (if This.Added = Nothing_Added
        then To_Sticks'Result = Law_Inputs.No_Sticks);

   function To_Commands (This : Run) return Law_Inputs.Command_Inputs is
     (if This.Place = At_Command
      then
        (Bank     => This.Added (Left_Aileron),
         Pitch    => This.Added (Left_Elevator),
         Altitude => This.Added (Left_Rudder),
         Airspeed => This.Added (Right_Rudder))
      else Law_Inputs.No_Commands)
   with
     Global => null,
     Post   =>
       (if This.Added = Nothing_Added
        then To_Commands'Result = Law_Inputs.No_Commands);

   --  No card runs, and no inputs of one remain.
   function Is_Idle (This : Run) return Boolean is
     (This.Running = 0 and then This.Added = Nothing_Added)
   with Global => null;

   --  The largest input that the running card may have on a surface.
   function Authority (Deck : Card_Deck; This : Run; Which : Test_Surface)
                       return Number
   is
     (if This.Running > 0 and then Moves (Deck (This.Running), Which)
      then Number (Deck (This.Running) (Amplitude))
      else 0)
   with
     Global => null,
     Post   => Authority'Result in 0 .. 4_095;

   function Next (This : Run; Deck : Card_Deck; Sight : Situation) return Run
   with
     Global => null,
     Post   =>

       --  A card runs only while all its conditions are met.
       (if Next'Result.Running > 0
        then Is_Ready (Deck, Next'Result.Running)
          and then Judged (Deck (Next'Result.Running), Sight) = Well
          and then Are_Resting (Next'Result, Sight.Heard)
          and then Next'Result.Frame <
                     Length_Of (Deck (Next'Result.Running))
          and then Next'Result.Place =
                     Place_Of (Deck (Next'Result.Running))

          --  It began when the switch went on, or it goes on frame by frame.
          and then
            (if This.Running = 0
             then Is_Started (This, Sight)
               and then Next'Result.Running = This.Chosen
               and then Next'Result.Frame = 0
             else Next'Result.Running = This.Running
               and then Next'Result.Frame = This.Frame + 1
               and then Next'Result.Roll_Rest = This.Roll_Rest
               and then Next'Result.Pitch_Rest = This.Pitch_Rest
               and then Next'Result.Yaw_Rest = This.Yaw_Rest))

       --  Inputs remain where they were added, until they are 0.
       and then
         (if This.Added /= Nothing_Added
          then Next'Result.Place = This.Place)

       --  Nothing is added after the pilot's disconnect.
       and then
         (if Sight.Is_Cut then Next'Result.Added = Nothing_Added)

       --  Otherwise each input moves within its rate limit, and is within the
       --  running card's amplitude or returns to it.
       and then
         (for all Which in Test_Surface =>
            (if not Sight.Is_Cut
             then abs (Next'Result.Added (Which) - This.Added (Which)) <=
                    Rate_Step (Which))
            and then
              abs Next'Result.Added (Which) <=
                Integer'Max
                  (Authority (Deck, Next'Result, Which),
                   abs This.Added (Which) - Rate_Step (Which)))

       and then Next'Result.Was_On =
         (if Sight.Is_New then Is_On (Sight.Heard (Switch_5))
          else This.Was_On)

       --  Without a card only the switch is noted.
       and then
         (if Is_Idle (This) and then not Is_Started (This, Sight)
          then Next'Result =
            (This with delta
               Was_On =>
                 (if Sight.Is_New then Is_On (Sight.Heard (Switch_5))
                  else This.Was_On)));

   --  After a warm start no card runs; the inputs return to 0.
   function After_Restart (This : Aboard) return Aboard is
     ((This with delta
         Run =>
           (This.Run with delta
              Running => 0,
              Was_On  => True,
              Reason  =>
                (if This.Run.Running > 0 then Restarted
                 else This.Run.Reason))))
   with Global => null;

   --  A card from the ground

   type Answer is
     (Taken,
      Not_Whole,      --  its words disagree
      Not_In_Range,   --  a value is not permitted
      Card_Runs,      --  a card runs, or switch 5 is on
      No_Laws,        --  the laws are off
      Slot_Empty);    --  the chosen slot has no card

   subtype Refused is Answer range Not_Whole .. Slot_Empty;

   --  On: the laws are on.
   function Answer_To (Block : Uplink_Buffer; Before : Aboard; On : Boolean)
                       return Answer
   is
     (if not Is_Whole (Block) then Not_Whole
      elsif not Is_In_Range (Card_Of (Block)) then Not_In_Range
      elsif not On then No_Laws
      elsif Before.Run.Running > 0 or else Before.Run.Was_On then Card_Runs
      elsif Kind_Of (Card_Of (Block)) = Choose
        and then not Is_Loaded (Before.Deck (Slot_Of (Card_Of (Block))))
      then Slot_Empty
      else Taken)
   with Global => null;

   --  The slot of the next run after a card that is taken. A new card is
   --  chosen if no other one is.
   function Chosen_After (Source : Card; Before : Slot_Or_None)
                          return Slot_Or_None
   is
     (if Kind_Of (Source) = Choose or else
        (Kind_Of (Source) /= Empty and then Before = 0)
      then Slot_Of (Source)
      elsif Kind_Of (Source) = Empty and then Before = Slot_Of (Source)
      then 0
      else Before)
   with
     Global => null,
     Pre    => Is_In_Range (Source);

   --  A refused block changes nothing.
   function After_Block (Block : Uplink_Buffer; Before : Aboard; On : Boolean)
                         return Aboard
   is
     (if Answer_To (Block, Before, On) /= Taken then Before
      else
        (Deck =>
           (if Kind_Of (Card_Of (Block)) = Choose then Before.Deck
            else
              (Before.Deck with delta
                 Slot_Of (Card_Of (Block)) =>
                   (if Kind_Of (Card_Of (Block)) = Empty then Empty_Card
                    else Card_Of (Block)))),
         Run  =>
           (Before.Run with delta
              Chosen => Chosen_After (Card_Of (Block), Before.Run.Chosen))))
   with Global => null;

end URV.Test_Runs;
