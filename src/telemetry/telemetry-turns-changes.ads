--  SPDX-License-Identifier: Apache-2.0

--  The changes of a board's control in place (LNK-9): the same as the
--  functions of Telemetry.Turns, without a copy of what stays.

package Telemetry.Turns.Changes with Pure, SPARK_Mode is

   procedure Reset_Control (This : in out Control; Blocks : Buffer_Pair)
   with
     Global => null,
     Post   => This = Reset (This'Old, Blocks);

   --  Block is Delivery_After.
   procedure Inform
     (This    : in out Control;
      Trigger : Event;
      Block   : Delivery;
      Blocks  : Buffer_Pair)
   with
     Global => null,
     Pre    => Block = Delivery_After (This, Trigger),
     Post   => This = Informed (This'Old, Trigger, Blocks);

   procedure Judge_Message (This : in out Control; Received : Buffer_Pair)
   with
     Global => null,
     Post   => This = Judged (This'Old, Received);

   --  Begins is May_Begin_Block.
   procedure Prepare
     (This   : in out Control;
      Blocks : Buffer_Pair;
      Begins : Boolean)
   with
     Global => null,
     Pre    => Begins = May_Begin_Block (This, Blocks),
     Post   => This = Prepared (This'Old, Blocks);

   procedure Note_Spoken (This : in out Control; Blocks : Buffer_Pair)
   with
     Global => null,
     Pre    => Fits (This, Blocks),
     Post   => This = Spoken (This'Old, Blocks);

end Telemetry.Turns.Changes;
