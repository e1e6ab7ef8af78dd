--  SPDX-License-Identifier: Apache-2.0

--  The outside of a simulated chip (BRD-6): events between the program's
--  accesses, as a plan says. An event is a character that arrives, or the end
--  of a timer's period.

with URVOS; use URVOS;

package Simulated_Line is

   --  The number of events just before each access. None come after the last
   --  one.

   Planned_Accesses : constant := 16;
   subtype Access_Number is Positive range 1 .. Planned_Accesses;

   subtype Event_Count is Natural range 0 .. 9;
   type Event_Plan is array (Access_Number) of Event_Count;

   --  Begins a plan, with characters from number 0 on.
   procedure Begin_Plan (Plan : Event_Plan);

   --  The next access begins, after this number of events.
   procedure Begin_Access (Events : out Event_Count);

   --  All planned accesses are over.
   function Is_Over return Boolean;

   --  The character with this number that the other side sends: data that
   --  differ up to 256 characters, and all combinations of errors.

   type Sent_Character is record
      Data          : Byte;
      Wrong_Parity  : Boolean;
      Wrong_Framing : Boolean;
   end record;

   function Sent (Number : Natural) return Sent_Character is
     ((Data          => Byte (Number * 37 mod 256),
       Wrong_Parity  => Number mod 3 = 1,
       Wrong_Framing => Number mod 4 >= 2));

   --  The next character arrives.
   procedure Arrive (Item : out Sent_Character);

   --  The number of characters that have arrived.
   function Arrived return Natural;

end Simulated_Line;
