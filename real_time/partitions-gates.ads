--  SPDX-License-Identifier: Apache-2.0

--  Where two tasks keep each other out of something that takes its time: who
--  comes second waits until the first has left (D-30).

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;

package Partitions.Gates is

   --  The two tasks.
   type Side is (Left, Right);

   type Gate is limited private;

   --  Enter returns when the other side is not inside. Each side enters, and
   --  then leaves.
   procedure Enter (Through : in out Gate; From : Side);
   procedure Leave (Through : in out Gate; From : Side);

private

   type Sides is array (Side) of Boolean;

   protected type Order is

      --  Passed is False when the other side is inside.
      procedure Ask (From : Side; Passed : out Boolean);

      --  Other_Waits tells that the other side is inside now.
      procedure Leave (From : Side; Other_Waits : out Boolean);

   private
      Is_Inside : Sides := (others => False);
      Waits     : Sides := (others => False);
   end Order;

   --  Each side waits at its own: two at one suspension object may both stay
   --  there.
   type Turns is array (Side) of Suspension_Object;

   type Gate is limited record
      Order : Gates.Order;
      Turn  : Turns;
   end record;

end Partitions.Gates;
