--  SPDX-License-Identifier: Apache-2.0

--  JSBSim's process and the connection to it. Each side sees when the other
--  one has ended, so that none outlives the other.

with Ada.Streams; use Ada.Streams;

private package Sim.JSBSim.Process is

   --  Starts the process. Raises Bad_Input when the interpreter or the
   --  script is missing.
   procedure Spawn;

   --  Raise Plant_Failure when the process has ended, Plant_Silence when it
   --  gives no sign of life for a minute.
   procedure Send (Message : Stream_Element_Array);
   procedure Receive (Message : out Stream_Element_Array);

   --  To look for an answer has been in vain: the other process hardly runs
   --  while this one does.
   function Is_Alone return Boolean;

   --  What comes up to the next line feed.
   function Received_Line return String;

   --  Ends the connection, and with it the process.
   procedure Stop;

   --  Stops, and refuses the command line with a word on how to help.
   procedure Give_Up (Why : String) with No_Return;

   --  The same with the process's own words.
   procedure Refuse_Flight (Answer : String) with No_Return;

end Sim.JSBSim.Process;
