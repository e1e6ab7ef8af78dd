--  SPDX-License-Identifier: Apache-2.0

package body Sim.Agenda is

   --  The time and, so that one comparison finds the first of several at
   --  the same instant, the place of the event in the order of events.
   type Entry_Time is range 0 .. 2 ** 63 - 1;
   Never  : constant Entry_Time := Entry_Time'Last;
   Places : constant := 16;
   pragma Compile_Time_Error
     (Event'Range_Length > Places, "every event needs its place");

   Entries : array (Event) of Entry_Time := (others => Never);

   procedure Clear is
   begin
      Entries := (others => Never);
   end Clear;

   procedure Schedule (What : Event; Time : Microseconds) is
   begin
      Entries (What) :=
        Entry_Time (Time) * Places + Event'Pos (What);
   end Schedule;

   procedure Cancel (What : Event) is
   begin
      Entries (What) := Never;
   end Cancel;

   function Is_Due (What : Event) return Boolean is
     (Entries (What) /= Never);

   procedure Find_First (What : out Event; Time : out Microseconds) is
      First : Entry_Time := Entries (Event'First);
   begin
      for Candidate in Event range Event'Succ (Event'First) .. Event'Last
      loop
         First := Entry_Time'Min (First, Entries (Candidate));
      end loop;
      What := Event'Val (First mod Places);
      Time := Microseconds (First / Places);
   end Find_First;

   function First_Besides (What : Event) return Microseconds is
      First : Entry_Time := Never;
   begin
      for Candidate in Event loop
         if Candidate /= What then
            First := Entry_Time'Min (First, Entries (Candidate));
         end if;
      end loop;
      return Microseconds (First / Places);
   end First_Besides;

end Sim.Agenda;
