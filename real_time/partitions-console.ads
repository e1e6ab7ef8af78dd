--  SPDX-License-Identifier: Apache-2.0

--  The pilot's console: sticks and switches at rest, as a file says
--  (--sticks), as packets of another process say (--console), or as the
--  simulated pilot moves them (--pilot; GND-3, GND-5), and what goes up when
--  the console is lost (GND-4, SAF-10).

with Host;            use Host;
with Host.Text_Output;
with Partitions.Octets;
with Partitions.Rows; use Partitions.Rows;
with URV.Buffers;     use URV.Buffers;
with URVOS;

package Partitions.Console is

   procedure Load (File : String);

   --  Who flies when no console does otherwise. Raises Host.Bad_Input when
   --  the pilot does not know the flight.
   procedure Take_Aboard (Pilot_Flight : String);

   --  What the A/D board's channels see. Without Is_There the converter brings
   --  no scan: the console is lost (SAF-10).
   procedure Sample
     (Is_Next  : Boolean;
      Words    : out Channel_Words;
      Is_There : out Boolean);

   --  The names and the values of the record's columns that this node has.
   function Column_Names return String;
   procedure Append_Values (To : in out Row);

   --  The same of what the aircraft tells of its control laws (GND-7): 0 when
   --  nothing has come.
   function Law_Names return String;
   procedure Append_Laws (To : in out Row);

   --  Live: its words go up. Held: no packet for 0.5 s, or none ever; nothing
   --  fresh goes up. Neutral: none for 2 s, or none ever, and the aircraft is
   --  on the ground; the safe words go up.
   type Console_State is (No_Console, Live, Held, Neutral);

   type Pilot_State is (No_Pilot, Hands_Off, Flies);

   --  What the converter saw last, and whose it was. Has_Come: the console has
   --  sent a packet at least. Sequence is that of the
   --  console packet, 0 when the words are of none.
   type Sticks is record
      Words    : Console_Words := Neutral_Console;
      State    : Console_State := No_Console;
      Has_Come : Boolean := False;
      Pilot    : Pilot_State := No_Pilot;
      Sequence : Octets.Number := 0;
   end record;

   --  Of the latest row. For who has the row taken.
   function Recorded return Sticks;

   --  How often a console that had come was lost, and how often the safe words
   --  went up for it.
   function Times_Held return URVOS.Count;
   function Times_Neutral return URVOS.Count;

   --  What has become of the console and the pilot since it was last asked,
   --  for people; nothing when all is as it was. It is now so many
   --  seconds.
   function Next_News (Now : String) return String;

   --  Lines of --events.
   procedure Put_Events (To : in out Host.Text_Output.Writer);

end Partitions.Console;
