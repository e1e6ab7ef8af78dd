--  SPDX-License-Identifier: Apache-2.0

--  Without a controller the servos go to safe words within 0.5 s: throttle
--  idle, surfaces at zero, discretes off, the brake unchanged. With a
--  controller the timer never interferes (SAF-11, D-34). Both hold for the PWM
--  board from every state and for ever. The board's clock is assumed to tick.

with Devices.PWM_Board; use Devices.PWM_Board;
with URV.Buffers;       use URV.Buffers;
with URV.PWM_Layout;    use URV.PWM_Layout;
with URVOS;             use URVOS;

package Theorems.Hold_Timers with SPARK_Mode, Ghost is

   --  After 0.5 s without a touch, from any state: throttle idle, surfaces,
   --  flaps and steering at zero, the discretes off, the brake unchanged. More
   --  time changes nothing.
   procedure Without_A_Controller_The_Outputs_Are_Safe
     (Item : in out Board_State; Ticks : Positive)
   with
     Global => null,
     Pre    => Ticks >= Hold_Ticks,
     Post   =>
       (for all Servo in PWM_Item =>
          Item.Words (Channel_Of (Servo)) =
            (if Servo = Brake
             then Item.Words'Old (Channel_Of (Brake))
             else Safe_Outputs (Servo)));

   --  The ticks between one touch and the next.
   type Gap is range 0 .. Hold_Ticks - 1;
   type Gap_List is array (Positive range <>) of Gap;

   --  While the controller touches the board within every 0.5 s, its words
   --  remain for ever.
   procedure With_A_Controller_Nothing_Moves
     (Item : in out Board_State; Gaps : Gap_List)
   with
     Global => null,
     Pre    => Item.Untouched = 0,
     Post   => Item = Item'Old;

   --  The controller's words take effect at once, whatever the timer did.
   procedure A_Write_Is_Obeyed (Item : Board_State; Area : Data_Area)
   with
     Global => null,
     Post   =>
       Written (Area).Words = Area
       and then Touched (Item).Words = Item.Words
       and then Touched (Item).Untouched = 0;

end Theorems.Hold_Timers;
