--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time; use Ada.Real_Time;
with Ada.Text_IO;

procedure Bench_Times is

   Turns : constant := 31;

   Took    : array (1 .. Turns) of Long_Float := (others => 0.0);
   Started : Time;
   Now     : Long_Float;
   Place   : Natural;
begin
   for Turn in Took'Range loop
      Started := Clock;
      for Number in 1 .. Calls loop
         Call (Number);
      end loop;
      Now := Long_Float (To_Duration (Clock - Started));
      Place := Turn - 1;
      while Place > 0 and then Took (Place) > Now loop
         Took (Place + 1) := Took (Place);
         Place := Place - 1;
      end loop;
      Took (Place + 1) := Now;
   end loop;
   --  Tenths of a nanosecond.
   declare
      Tenths : constant Natural :=
        Natural
          (1.0E10 * Took (Turns / 2 + 1)
           / (Long_Float (Calls) * Long_Float (Each)));
      Last   : constant String := Natural'Image (Tenths mod 10);
   begin
      Ada.Text_IO.Put_Line
        (What & Natural'Image (Tenths / 10) & '.' & Last (Last'Last));
   end;
end Bench_Times;
