--  SPDX-License-Identifier: Apache-2.0

--  The PWM board's hold timer (SAF-11, D-34), from any state of the board.

with Devices.PWM_Board; use Devices.PWM_Board;
with URV.Buffers;       use URV.Buffers;
with URV.PWM_Layout;    use URV.PWM_Layout;
with URVOS;             use URVOS;

package Theorems.Hold_Timers with SPARK_Mode, Ghost is

   --  0.5 s without a touch, from any state: throttle idle, surfaces, flaps
   --  and steering at zero, the discretes off, the brake as it was. More time
   --  changes nothing.
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

   --  Ticks between one touch and the next.
   type Gap is range 0 .. Hold_Ticks - 1;
   type Gap_List is array (Positive range <>) of Gap;

   --  While the controller touches the board before 0.5 s are over, each time,
   --  the words stay as it wrote them, for ever.
   procedure With_A_Controller_Nothing_Moves
     (Item : in out Board_State; Gaps : Gap_List)
   with
     Global => null,
     Pre    => Item.Untouched = 0,
     Post   => Item = Item'Old;

   --  What the controller writes is there at once, whatever the timer did.
   procedure A_Write_Is_Obeyed (Item : Board_State; Area : Data_Area)
   with
     Global => null,
     Post   =>
       Written (Area).Words = Area
       and then Touched (Item).Words = Item.Words
       and then Touched (Item).Untouched = 0;

end Theorems.Hold_Timers;
