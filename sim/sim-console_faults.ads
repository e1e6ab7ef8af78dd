--  SPDX-License-Identifier: Apache-2.0

--  A pilot's console whose packets are lost (SAF-10, SIM-7), as seen by the
--  ground's converter: for 0.5 s the words of its last scan, then no scan, or
--  on the ground the safe words.

with Sim.Faults;
with URV.Buffers; use URV.Buffers;
with URVOS;       use URVOS;

private package Sim.Console_Faults is

   procedure Prepare (Script : Faults.Script);

   --  True if the flight has such a fault.
   function Are_There return Boolean with Inline;

   --  The ground's controller has begun a scan; the console has these words.
   procedure Begin_Scan (Time : Microseconds; Console : Channel_Words);

   --  A channel of the present scan has been converted while the console is
   --  connected: its word is kept if this is the last scan before the console
   --  falls silent.
   procedure Keep (Which : Channel; Item : Word);

   --  The present scan: whether the converter completes one, whether it has
   --  the console's own words, and the words otherwise.

   function Brings_Scan return Boolean with Inline;
   function Is_Live return Boolean with Inline;
   function Words return Channel_Words with Inline;

end Sim.Console_Faults;
