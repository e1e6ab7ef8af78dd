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

   --  A card ran, or should have run in this frame, and runs no more.
   function Has_Ended (Before, After : Run; Sight : Situation) return Boolean
   is
     ((Is_Running (Before) or else Is_Started (Before, Sight))
      and then not Is_Running (After))
   with Global => null;

   --  The number of slots between two, from the first again after the last.
   function Between (From : Slot_Or_None; To : Slot) return Number is
     ((Number (To) - Number (From) - 1) mod Number (Slot'Last))
   with Global => null, Ghost;

   --  The next loaded slot after a slot, from the first again after the last;
   --  0 if there is none.
   function Next_Loaded (Deck : Card_Deck; From : Slot_Or_None)
                         return Slot_Or_None
   with
     Global => null,
     Post   =>
       (if Next_Loaded'Result > 0
        then Is_Loaded (Deck (Next_Loaded'Result)))
       and then
         (for all Which in Slot =>
            (if Is_Loaded (Deck (Which))
             then Next_Loaded'Result > 0
               and then Between (From, Next_Loaded'Result) <=
                          Between (From, Which)));

   --  The verdict on the chosen card when its switch goes on.
   function Start_Of (This : Run; Deck : Card_Deck; Sight : Situation)
                      return Verdict
   is
     (if not Is_Ready (Deck, This.Chosen) then Not_Loaded
      else
        (declare
           Found : constant Verdict := Judged (Deck (This.Chosen), Sight);
         begin
           (if Found /= Well then Found
            elsif This.Added /= Nothing_Added
              and then Place_Of (Deck (This.Chosen)) /= This.Place
            then Inputs_Remain
            else Well)))
   with Global => null;

   --  The reason for which the running card ends in a frame; Well if it goes
   --  on.
   function End_Of (This : Run; Deck : Card_Deck; Sight : Situation)
                    return Verdict
   is
     (if not Is_Ready (Deck, This.Running)
        or else Place_Of (Deck (This.Running)) /= This.Place
      then Not_Loaded
      else
        (declare
           Found : constant Verdict := Judged (Deck (This.Running), Sight);
         begin
           (if Found /= Well then Found
            elsif not Are_Resting (This, Sight.Heard) then Stick_Moved
            elsif This.Frame >= Length_Of (Deck (This.Running)) - 1
            then Complete
            else Well)))
   with Global => null;

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

   --  The card after a frame. It begins when its switch goes on, and goes on
   --  frame by frame, only while all its conditions are met. The reason of its
   --  end is kept. After a complete card the next one is chosen.
   function Is_Selected
     (Before, After : Run; Deck : Card_Deck; Sight : Situation) return Boolean
   is
     ((if After.Running > 0
       then Is_Ready (Deck, After.Running)
         and then Judged (Deck (After.Running), Sight) = Well
         and then Are_Resting (After, Sight.Heard)
         and then After.Frame < Length_Of (Deck (After.Running))
         and then After.Place = Place_Of (Deck (After.Running)))
      and then
        (if Before.Running > 0
         then
           (if End_Of (Before, Deck, Sight) = Well
            then After.Running = Before.Running
              and then After.Frame = Before.Frame + 1
              and then After.Phase =
                         Next_Phase
                           (Deck (Before.Running), Before.Frame, Before.Phase)
              and then After.Roll_Rest = Before.Roll_Rest
              and then After.Pitch_Rest = Before.Pitch_Rest
              and then After.Yaw_Rest = Before.Yaw_Rest
              and then After.Last_Run = Before.Last_Run
              and then After.Reason = Before.Reason
            else After.Running = 0
              and then After.Last_Run = Before.Running
              and then After.Reason = End_Of (Before, Deck, Sight))
         elsif Is_Started (Before, Sight)
         then After.Running =
             (if Start_Of (Before, Deck, Sight) = Well then Before.Chosen
              else 0)
           and then
             (if After.Running > 0
              then After.Frame = 0
                and then After.Phase = 0
                and then After.Roll_Rest = Demand_Of (Sight.Heard (Roll))
                and then After.Pitch_Rest = Demand_Of (Sight.Heard (Pitch))
                and then After.Yaw_Rest = Demand_Of (Sight.Heard (Yaw)))
           and then After.Last_Run = Before.Chosen
           and then After.Reason = Start_Of (Before, Deck, Sight)
         else After.Running = 0
           and then After.Last_Run = Before.Last_Run
           and then After.Reason = Before.Reason)
      and then After.Chosen =
        (if Before.Running > 0
           and then End_Of (Before, Deck, Sight) = Complete
         then Next_Loaded (Deck, Before.Running)
         else Before.Chosen))
   with Global => null, Ghost;

   --  The signal of the running card for a surface, before the limit of its
   --  rate.
   function Signal_Of (This : Run; Deck : Card_Deck; Which : Test_Surface)
                       return Increment
   is
     (if This.Running > 0
      then Signal (Deck (This.Running), This.Frame, This.Phase, Which)
      else 0)
   with
     Global => null,
     Pre    =>
       (if This.Running > 0
        then Is_Ready (Deck, This.Running)
          and then This.Frame < Length_Of (Deck (This.Running))),
     Post   => abs Signal_Of'Result <= Authority (Deck, This, Which);

   --  A surface's input after a frame with this signal.
   function Moved (Before, Signal : Increment; Which : Test_Surface)
                   return Increment
   is
     (Stepped (Before, Signal, Rate_Step (Which)))
   with
     Global => null,
     Post   =>
       abs (Moved'Result - Before) <= Rate_Step (Which)
       and then
         abs Moved'Result <=
           Integer'Max (abs Signal, abs Before - Rate_Step (Which));

   function Next (This : Run; Deck : Card_Deck; Sight : Situation) return Run
   with
     Global => null,
     Post   =>
       Is_Selected (This, Next'Result, Deck, Sight)

       --  Inputs remain where they were added, until they are 0.
       and then
         (if This.Added /= Nothing_Added
          then Next'Result.Place = This.Place)

       --  Nothing is added after the pilot's disconnect.
       and then
         (if Sight.Is_Cut then Next'Result.Added = Nothing_Added)

       --  Otherwise each input moves to the card's signal within its rate
       --  limit. It is within the running card's amplitude or returns to it.
       and then
         (for all Which in Test_Surface =>
            (if not Sight.Is_Cut
             then abs (Next'Result.Added (Which) - This.Added (Which)) <=
                    Rate_Step (Which)
               and then Next'Result.Added (Which) =
                 Moved
                   (This.Added (Which), Signal_Of (Next'Result, Deck, Which),
                    Which))
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
