--  SPDX-License-Identifier: Apache-2.0

with Ada.Containers.Doubly_Linked_Lists;

package body Sim.Slow_Lines is

   type Coming is record
      Time  : Microseconds;
      Heard : Arrival;
   end record;

   package Lists is new Ada.Containers.Doubly_Linked_Lists (Coming);

   --  In the order of their times.
   Ways : array (Direction) of Lists.List;

   procedure Clear is
   begin
      for Each of Ways loop
         Each.Clear;
      end loop;
   end Clear;

   procedure Put (Way : Direction; Time : Microseconds; Heard : Arrival) is
      Place : Lists.Cursor := Ways (Way).Last;
   begin
      --  A doubled character may arrive after the following one has begun.
      while Lists.Has_Element (Place)
        and then Lists.Element (Place).Time > Time
      loop
         Lists.Previous (Place);
      end loop;
      if Lists.Has_Element (Place) then
         Ways (Way).Insert (Lists.Next (Place), (Time, Heard));
      else
         Ways (Way).Prepend ((Time, Heard));
      end if;
   end Put;

   function Next_Time (Way : Direction) return Microseconds is
     (if Ways (Way).Is_Empty then Host.Never
      else Ways (Way).First_Element.Time);

   procedure Take (Way : Direction; Heard : out Arrival) is
   begin
      Heard := Ways (Way).First_Element.Heard;
      Ways (Way).Delete_First;
   end Take;

end Sim.Slow_Lines;
