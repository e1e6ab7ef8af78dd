--  SPDX-License-Identifier: Apache-2.0

--  One board with what it has on the line: every state it can be in, and
--  where a character time leads from each.
--
--  The states are records of type Board, and every step is a call of its
--  operations. As a child this package sees what a board is made of. Results
--  are kept, so that each is called once for each state. Two boards that
--  differ only in what can never make a difference outside, or in what their
--  blocks say, are one state (Normal); Check_Normal verifies that.

with Explore; use Explore;

generic
   Role : Station;
package Telemetry.Boards.Sides is

   --  Finds every state that any input whatever can lead to: any character
   --  at any time with or without parity error, time passing or not, blocks
   --  put, polls, the board and its controller reset.
   procedure Explore_Alone;

   function Boards_Found return Natural;
   function Sides_Found return Natural;
   function Calls_Made return Natural;

   function On_Line (Item : Side) return Symbol with Inline;

   --  Nothing on the line or owed, and nothing waited for but the end of
   --  the ground's idle time.
   function Is_Quiet (Item : Side) return Boolean;

   --  The last character of a data message is on the line, of one followed
   --  if Fresh.
   function Ends_Block (Item : Side; Fresh : Boolean) return Boolean;

   --  A data message has come to its end here and is not judged yet.
   function Waits_At_End (Item : Side) return Boolean;

   --  The outcomes of a character time at whose end Heard comes in, in every
   --  order of what happens in it: First to Last of Nth.
   procedure Step
     (From        : Side;
      Heard       : Symbol;
      Controller  : Controller_Act;
      First, Last : out Natural)
   with Inline;

   function Nth (Index : Positive) return Outcome with Inline;

   function Image (Item : Side) return String;

   --  Gives every board that Explore_Alone found a content by chance in all
   --  that Normal leaves out, Trials times, and verifies that nothing is lost
   --  by it: whatever an operation does to that board, with any byte, is
   --  among what it does to the normal one. Calls counts them.
   procedure Check_Normal
     (Trials : Positive; Calls : out Natural; Is_Exact : out Boolean);

end Telemetry.Boards.Sides;
