--  SPDX-License-Identifier: Apache-2.0

--  Mutual exclusion of two tasks over a longer operation: the second one waits
--  until the first has left (D-30).

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

      --  Other_Waits: the other side is inside now.
      procedure Leave (From : Side; Other_Waits : out Boolean);

   private
      Is_Inside : Sides := (others => False);
      Waits     : Sides := (others => False);
   end Order;

   --  Each side has its own suspension object: of two tasks at a common one
   --  both may stay blocked.
   type Turns is array (Side) of Suspension_Object;

   type Gate is limited record
      Order : Gates.Order;
      Turn  : Turns;
   end record;

end Partitions.Gates;
