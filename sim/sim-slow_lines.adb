--  SPDX-License-Identifier: Apache-2.0

with Ada.Containers.Doubly_Linked_Lists;

package body Sim.Slow_Lines is

   type Coming is record
      Time  : Microseconds;
      Heard : Arrival;
   end record;

   package Lists is new Ada.Containers.Doubly_Linked_Lists (Coming);

   --  In the order of their times.
   Paths : array (Direction) of Lists.List;

   procedure Clear is
   begin
      for Each of Paths loop
         Each.Clear;
      end loop;
   end Clear;

   procedure Put (Path : Direction; Time : Microseconds; Heard : Arrival) is
      Place : Lists.Cursor := Paths (Path).Last;
   begin
      --  A doubled character may arrive after the following one has begun.
      while Lists.Has_Element (Place)
        and then Lists.Element (Place).Time > Time
      loop
         Lists.Previous (Place);
      end loop;
      if Lists.Has_Element (Place) then
         Paths (Path).Insert (Lists.Next (Place), (Time, Heard));
      else
         Paths (Path).Prepend ((Time, Heard));
      end if;
   end Put;

   function Next_Time (Path : Direction) return Microseconds is
     (if Paths (Path).Is_Empty then Host.Never
      else Paths (Path).First_Element.Time);

   procedure Take (Path : Direction; Heard : out Arrival) is
   begin
      Heard := Paths (Path).First_Element.Heard;
      Paths (Path).Delete_First;
   end Take;

end Sim.Slow_Lines;
