--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Rows is

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
            Ready := True;
         end if;
      end Put;

      procedure Finish is
      begin
         Done := True;
         Ready := True;
      end Finish;

      entry Take (Item : out Row; Found : out Boolean) when Ready is
      begin
         Item := Rows (First);
         Found := Length > 0;
         if Found then
            First := First + 1;
            Length := Length - 1;
         end if;
         Ready := Done or else Length > 0;
      end Take;

      function Left_Out return Count is (Missing);

   end Queue;

end Partitions.Rows;
