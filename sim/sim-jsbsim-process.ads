--  SPDX-License-Identifier: Apache-2.0

--  JSBSim's process and the connection to it. Each side sees the end of the
--  other one, so that neither outlives the other.

with Ada.Streams; use Ada.Streams;

private package Sim.JSBSim.Process is

   --  Starts the process. Raises Bad_Input when the interpreter or the script
   --  is missing.
   procedure Spawn;

   --  Raise Plant_Failure when the process has ended, Plant_Silence when it
   --  has not answered for a minute.
   procedure Send (Message : Stream_Element_Array);
   procedure Receive (Message : out Stream_Element_Array);

   --  True if polling for an answer has failed: the other process hardly runs
   --  while this one polls.
   function Is_Alone return Boolean;

   --  The received bytes up to the next line feed.
   function Received_Line return String;

   --  Ends the connection, and with it the process.
   procedure Stop;

   --  Stops, and refuses the command line with a hint at the remedy.
   procedure Give_Up (Why : String) with No_Return;

   --  The same with the process's own words.
   procedure Refuse_Flight (Answer : String) with No_Return;

end Sim.JSBSim.Process;
