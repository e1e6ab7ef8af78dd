--  SPDX-License-Identifier: Apache-2.0

--  The pulse width modulation board (report, 2.3.1, 4.8, INI-3).
--
--  The board reads its data area continuously: one word for each servo
--  channel, then the discretes.
--
--  A timer counts the ticks of the board's own clock since the controller last
--  wrote to or touched the board (SAF-11, D-34). At 0.5 s the board replaces
--  the words by those for an aircraft without a controller, until the
--  controller writes again.

with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;

package Devices.PWM_Board with Pure, SPARK_Mode is

   --  16 channels; the vehicle uses the first 14.
   type Channel_Number is range 1 .. 16;

   type Data_Area is array (Channel_Number) of Word;

   --  The middle of a channel's range: a surface at zero degrees.
   Neutral : constant Word := 16#800#;

   --  Ticks without a touch before the timer replaces the words: 0.5 s.
   Hold_Ticks : constant := 500_000 / Microseconds_Per_Tick;

   type Untouched_Ticks is range 0 .. Hold_Ticks;

   --  Changed: the words may be others than when the servos' side last looked.
   type Board_State is record
      Words     : Data_Area;
      Untouched : Untouched_Ticks := 0;
      Changed   : Boolean         := True;
   end record;

   --  The controller has touched the board without changing its words.
   function Touched (This : Board_State) return Board_State is
     ((This with delta Untouched => 0))
   with Global => null;

   function Written (Area : Data_Area) return Board_State is
     ((Words => Area, Untouched => 0, Changed => True))
   with Global => null;

   --  A tick of the board's clock. Unattended are the words for an aircraft
   --  without a controller.
   function Ticked
     (This : Board_State; Unattended : Data_Area) return Board_State
   is
     (if This.Untouched >= Hold_Ticks - 1
      then (Words => Unattended, Untouched => Hold_Ticks, Changed => True)
      else (This with delta Untouched => This.Untouched + 1))
   with
     Global => null,
     Post   =>
       (if Ticked'Result.Words /= This.Words then Ticked'Result.Changed);

   --  The next tick replaces the words.
   function Is_Left_Alone (This : Board_State) return Boolean is
     (This.Untouched >= Hold_Ticks - 1)
   with Global => null;

   --  In place. Count_Tick is any other tick, whatever the words without a
   --  controller are.

   procedure Touch (This : in out Board_State)
   with
     Inline,
     Global => null,
     Post   => This = Touched (This'Old);

   procedure Count_Tick (This : in out Board_State)
   with
     Inline,
     Global => null,
     Pre    => not Is_Left_Alone (This),
     Post   => This = Ticked (This'Old, Unattended => This'Old.Words);

   --  The servos' side looks.
   procedure Take_Change (This : in out Board_State; Changed : out Boolean)
   with
     Inline,
     Global => null,
     Post   => Changed = This.Changed'Old
       and then This = (This'Old with delta Changed => False);

end Devices.PWM_Board;
