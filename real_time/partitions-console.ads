--  SPDX-License-Identifier: Apache-2.0

--  The pilot's console: sticks and switches at rest, from a file (--sticks),
--  from packets of another process (--console), or moved by the simulated
--  pilot (--pilot; GND-3, GND-5); and the words that are sent when the console
--  is lost (GND-4, SAF-10).

with Host;            use Host;
with Host.Text_Output;
with Partitions.Octets;
with Partitions.Rows; use Partitions.Rows;
with URV.Buffers;     use URV.Buffers;
with URVOS;

package Partitions.Console is

   procedure Load (File : String);

   --  Sets the pilot that flies while no console does. Raises Host.Bad_Input
   --  when the pilot does not know the flight.
   procedure Take_Aboard (Pilot_Flight : String);

   --  The words at the A/D board's channels. Without Is_There the converter
   --  completes no scan: the console is lost (SAF-10).
   procedure Sample
     (Is_Next  : Boolean;
      Words    : out Channel_Words;
      Is_There : out Boolean);

   --  The names and the values of this node's columns of the record.
   function Column_Names return String;
   procedure Append_Values (To : in out Row);

   --  The same for the status of the aircraft's control laws (GND-7): 0 before
   --  the first downlink.
   function Law_Names return String;
   procedure Append_Laws (To : in out Row);

   --  Live: its words are sent. Held: no packet for 0.5 s, or none ever; no
   --  fresh words are sent. Neutral: none for 2 s, or none ever, and the
   --  aircraft is on the ground; the safe words are sent.
   type Console_State is (No_Console, Live, Held, Neutral);

   type Pilot_State is (No_Pilot, Hands_Off, Flies);

   --  The converter's last words, and their source. Has_Come: the console has
   --  sent at least one packet. Sequence is that of the console packet, 0 when
   --  the words have another source.
   type Sticks is record
      Words    : Console_Words := Neutral_Console;
      State    : Console_State := No_Console;
      Has_Come : Boolean := False;
      Pilot    : Pilot_State := No_Pilot;
      Sequence : Octets.Number := 0;
   end record;

   --  The state in the latest row. For the task that has the row taken.
   function Recorded return Sticks;

   --  Counts of losses of the console after its first packet, and of changes
   --  to the safe words.
   function Times_Held return URVOS.Count;
   function Times_Neutral return URVOS.Count;

   --  Changes of console and pilot since the last call, for people; empty when
   --  there are none. Now is the present time in seconds.
   function Next_Message (Now : String) return String;

   --  Lines of --events.
   procedure Put_Events (To : in out Host.Text_Output.Writer);

end Partitions.Console;
