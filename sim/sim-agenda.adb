--  SPDX-License-Identifier: Apache-2.0

package body Sim.Agenda is

   --  The time and the event's place in the order of events, so that one
   --  comparison finds the first of several at the same instant.
   type Entry_Time is mod 2 ** 64;
   Never  : constant Entry_Time := Entry_Time'Last;
   Places : constant := 16;
   pragma Compile_Time_Error
     (Event'Range_Length > Places, "every event needs its place");

   Entries : array (Event) of Entry_Time := (others => Never);

   --  A rare event is looked at only when it changes.
   Is_Rare    : constant array (Event) of Boolean :=
     (Arrival_Up | Arrival_Down | Extra_Up | Extra_Down | Hardware_Fault
        | GSC_Started | MCS_Started => True,
      others => False);
   First_Rare : Entry_Time := Never;

   procedure Enter (Item : Event; Time : Entry_Time) with Inline_Always;
   procedure Find_First_Rare with No_Inline;

   procedure Find_First_Rare is
   begin
      First_Rare := Never;
      for Candidate in Event loop
         if Is_Rare (Candidate) then
            First_Rare := Entry_Time'Min (First_Rare, Entries (Candidate));
         end if;
      end loop;
   end Find_First_Rare;

   procedure Enter (Item : Event; Time : Entry_Time) is
   begin
      Entries (Item) := Time;
      if Is_Rare (Item) then
         Find_First_Rare;
      end if;
   end Enter;

   procedure Clear is
   begin
      Entries := (others => Never);
      First_Rare := Never;
   end Clear;

   procedure Schedule (Item : Event; Time : Microseconds) is
   begin
      Enter (Item, Entry_Time (Time) * Places + Event'Pos (Item));
   end Schedule;

   procedure Cancel (Item : Event) is
   begin
      Enter (Item, Never);
   end Cancel;

   function Is_Due (Item : Event) return Boolean is
     (Entries (Item) /= Never);

   procedure Find_First (Item : out Event; Time : out Microseconds) is
      First : Entry_Time := First_Rare;
   begin
      for Candidate in Event loop
         if not Is_Rare (Candidate) then
            First := Entry_Time'Min (First, Entries (Candidate));
         end if;
      end loop;
      Item := Event'Val (First mod Places);
      Time := Microseconds (First / Places);
   end Find_First;

   function First_Besides (Item : Event) return Microseconds is
      First : Entry_Time := First_Rare;
   begin
      for Candidate in Event loop
         if not Is_Rare (Candidate) and then Candidate /= Item then
            First := Entry_Time'Min (First, Entries (Candidate));
         end if;
      end loop;
      return Microseconds (First / Places);
   end First_Besides;

end Sim.Agenda;
