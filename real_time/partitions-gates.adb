--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Gates is

   function Other (One : Side) return Side is
     (if One = Left then Right else Left);

   protected body Order is

      procedure Ask (From : Side; Passed : out Boolean) is
      begin
         Passed := not Is_Inside (Other (From));
         Is_Inside (From) := Passed;
         Waits (From) := not Passed;
      end Ask;

      procedure Leave (From : Side; Other_Waits : out Boolean) is
      begin
         Other_Waits := Waits (Other (From));
         Is_Inside (From) := False;
         Is_Inside (Other (From)) := Other_Waits;
         Waits (Other (From)) := False;
      end Leave;

   end Order;

   procedure Enter (Through : in out Gate; From : Side) is
      Passed : Boolean;
   begin
      Through.Order.Ask (From, Passed);
      if not Passed then
         Suspend_Until_True (Through.Turn (From));
      end if;
   end Enter;

   procedure Leave (Through : in out Gate; From : Side) is
      Other_Waits : Boolean;
   begin
      Through.Order.Leave (From, Other_Waits);
      if Other_Waits then
         Set_True (Through.Turn (Other (From)));
      end if;
   end Leave;

end Partitions.Gates;
