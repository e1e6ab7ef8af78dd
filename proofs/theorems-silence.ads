--  SPDX-License-Identifier: Apache-2.0

--  The link never hangs: on a silent line a telemetry board returns to rest
--  within 102 character times, 9.8 ms on a wire, from every state (LNK-9,
--  D-27). A slower line adds two round trips. This holds for both boards. It
--  assumes that the board's timer runs, and says nothing about a line on which
--  other characters keep coming.

with Telemetry;           use Telemetry;
with Telemetry.Boards;    use Telemetry.Boards;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Senders;   use Telemetry.Senders;
with Telemetry.Turns;     use Telemetry.Turns;

package Theorems.Silence with Pure, SPARK_Mode, Ghost is

   --  The rest of a wait after some silence.
   function Rest_Of (Wait : Character_Times; Item : Control) return Positive
   is
     (if Item.Line_Taken then Positive (Wait)
      elsif Item.Silence >= Wait then 1
      else Positive (Wait - Item.Silence))
   with Pre => Wait > 0;

   --  The ground's idle time after its wait.
   function Idle_After (Item : Control) return Natural is
     (if Item.Role = Ground then Natural (Idle_Time_On (Item.Round_Trip))
      else 0);

   --  The wait for the other board.
   function Dead (Item : Control) return Character_Times is
     (Dead_Space_On (Item.Round_Trip));

   --  The largest number of silent character times until the board is at rest.
   function Distance (Item : Control) return Natural is
     (case Item.State is
         when Ready =>
           (if Item.Owed /= None then 1
            elsif Item.Receiver.State = At_End
            then Rest_Of (Guard_Time, Item) + 1
            elsif Item.Receiver.State /= At_Start
            then Rest_Of (Dead (Item), Item)
            else 0),
         when Sending =>
           Natural (Message_Length (Item.Transmit_Length))
           - Natural (Item.Sender.Sent)
           + Natural (Dead (Item)) + Idle_After (Item),
         when Awaiting_Status =>
           Rest_Of (Dead (Item), Item) + Idle_After (Item),
         when Awaiting_Data =>
           (if Item.Receiver.State = At_End
            then Rest_Of (Guard_Time, Item) + 1
            else Rest_Of (Dead (Item), Item) + Idle_After (Item)),
         when Idling =>
           Rest_Of (Idle_Time_On (Item.Round_Trip), Item))
   with
     Pre =>
       (if Item.State = Sending
        then Item.Sender.Sent < Message_Length (Item.Transmit_Length));

   function Distance (Item : Board) return Natural is
     (Distance (Control_Of (Item)))
   with Pre => Is_Sound (Item);

   function At_Rest (Item : Board) return Boolean is
     (Is_At_Rest (Control_Of (Item)));

   --  No state is further away than a whole message, the dead space and the
   --  idle time: 102 character times, 9.8 ms, for the longest block on a wire,
   --  plus two round trips of a slower line (LNK-11).
   procedure No_State_Is_Far (Item : Board)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   =>
       Distance (Item) <=
         Longest_Block + 2 + 44 + 2 * Natural (Control_Of (Item).Round_Trip)
       and then (Distance (Item) = 0) = At_Rest (Item);

   --  One character time of silence: the main program has its turn, then time
   --  passes.
   procedure Live_On (Item : in out Board)
   with
     Global => null,
     Pre    => Is_Sound (Item) and then not At_Rest (Item),
     Post   =>
       Is_Sound (Item) and then Distance (Item) < Distance (Item'Old);

   --  In silence every board comes to rest within this distance.
   procedure Comes_To_Rest (Item : in out Board; Times : out Natural)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Distance (Item)),
     Pre                => Is_Sound (Item),
     Post               =>
       Is_Sound (Item)
       and then At_Rest (Item)
       and then Times <= Distance (Item'Old);

   --  After the ground's idle time of silence, an aircraft that waits and has
   --  also heard nothing has reset itself, or has answered its last message.
   procedure Ground_Waits_Longer_Than_Aircraft
     (Item : in out Board; Times : out Natural)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Control_Of (Item).Role = Aircraft
       and then not Is_Talking (Control_Of (Item)),
     Post   =>
       Is_Sound (Item)
       and then At_Rest (Item)
       and then Times <
         Natural (Idle_Time_On (Control_Of (Item'Old).Round_Trip));

   --  After two data messages the ground sends no third, whatever its
   --  controller puts. It commands or idles (D-28).
   procedure No_Third_In_A_Row (Item : Control; Blocks : Buffer_Pair)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Is_At_Rest (Item)
       and then Item.In_A_Row = Row_Count'Last,
     Post   =>
       Prepared (Item, Blocks).In_A_Row = Item.In_A_Row
       and then Prepared (Item, Blocks).State =
         (if Item.Downlink_Turns = 0 then Idling else Ready);

   --  A reset clears the count of data messages in a row (LNK-9).
   procedure A_Reset_Starts_A_Row (Item : Control; Blocks : Buffer_Pair)
   with
     Global => null,
     Post   =>
       Reset (Item, Blocks).In_A_Row = 0
       and then Reset (Item, Blocks).State in Ready | Idling;

   --  The ground may send again only after its idle time of silence: passing
   --  time clears the count only as that begins or ends.
   procedure Free_After_Idle_Time
     (Item : Control; Time : Character_Times; Blocks : Buffer_Pair)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then not Is_Judged_After (Item, Time)
       and then Item.Role = Ground,
     Post   =>
       (if Elapsed (Item, Time, Blocks).In_A_Row < Item.In_A_Row
        then Elapsed (Item, Time, Blocks).State = Idling
          or else Item.State = Idling)
       and then
         (if Item.State = Idling
            and then Elapsed (Item, Time, Blocks).State /= Idling
          then Natural (Item.Silence) + Natural (Time) >=
                 Natural (Idle_Time_On (Item.Round_Trip)));

   --  A line slower than a wire (LNK-11)

   --  A board still waits when the answer arrives: one round trip, the other
   --  board's guard time and the answer's first character after its own last
   --  character.
   procedure An_Answer_Is_Waited_For
     (Item   : Control;
      Line   : Line_Delay;
      Time   : Character_Times;
      Blocks : Buffer_Pair)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Item.Round_Trip = Round_Trip_Of (Line)
       and then Item.State in Awaiting_Status | Awaiting_Data
       and then Item.Receiver.State = At_Start
       and then Item.Silence = 0
       and then Integer (Time) * Microseconds_Per_Character <=
         2 * Line
         + Integer (Guard_Time + 1) * Microseconds_Per_Character,
     Post   =>
       not Is_Over_After (Item, Time)
       and then Elapsed (Item, Time, Blocks).State = Item.State;

   --  For every delay of the line, an exchange without faults and the ground's
   --  idle time fit in a frame, including two round trips (D-38).
   procedure An_Exchange_Fits_Into_A_Frame (Round_Trip : Round_Trip_Time)
   with
     Global => null,
     Post   =>
       Exchange + 2 * Integer (Round_Trip)
       + Integer (Idle_Time_On (Round_Trip)) < Room_In_Frame;

end Theorems.Silence;
