--  SPDX-License-Identifier: Apache-2.0

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;

package body Partitions.Rows is

   --  A row was put, or none follows.
   Rows_Waiting : Suspension_Object;

   procedure Append (To : in out Row; Value : Number) is
   begin
      To.Length := To.Length + 1;
      To.Value (To.Length) := Value;
   end Append;

   protected body Queue is

      procedure Put (Item : Row) is
      begin
         if Done then
            null;
         elsif Length = Capacity then
            Missing := Incremented (Missing);
         else
            Rows (First + Place'Mod (Length)) := Item;
            Length := Length + 1;
            Set_True (Rows_Waiting);
         end if;
      end Put;

      procedure Finish is
      begin
         Done := True;
         Set_True (Rows_Waiting);
      end Finish;

      procedure Take
        (Item    : out Row;
         Found   : out Boolean;
         Is_Over : out Boolean) is
      begin
         Item := Rows (First);
         Found := Length > 0;
         if Found then
            First := First + 1;
            Length := Length - 1;
         end if;
         Is_Over := Done;
      end Take;

      function Left_Out return Count is (Missing);

   end Queue;

   procedure Await (Item : out Row; Found : out Boolean) is
      Is_Over : Boolean;
   begin
      loop
         Queue.Take (Item, Found, Is_Over);
         exit when Found or else Is_Over;
         Suspend_Until_True (Rows_Waiting);
      end loop;
   end Await;

end Partitions.Rows;
