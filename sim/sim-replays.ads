--  SPDX-License-Identifier: Apache-2.0

--  Someone in the middle of the line who cannot make a message of his own:
--  in the place of one that is sent he puts one that was sent before, in
--  the same direction (SIM-2, SEC-4). With one some messages back the line
--  delays; with another one each time it withholds, repeats and reorders.

with Sim.Faults;
with URVOS; use URVOS;

private with Ada.Containers.Vectors;
private with Telemetry;

package Sim.Replays is

   type Middle is limited private;

   --  Takes over the replays of a direction. Without any, nothing changes.
   procedure Prepare
     (Made : in out Middle; Given : Faults.Fault_List);

   --  A character is sent at that time; Data becomes the one that goes on.
   --  Time must not decrease.
   procedure Replace
     (Through : in out Middle;
      Time    : Microseconds;
      Data    : in out Byte);

private

   --  An uplink or a downlink, with its header and its checksum.
   Longest : constant := Telemetry.Longest_Block + 2;

   type Character_Array is array (1 .. Longest) of Byte;

   type Message is record
      Length  : Positive range 1 .. Longest := 1;
      Content : Character_Array := (others => 0);
   end record;

   package Message_Vectors is new Ada.Containers.Vectors
     (Positive, Message);

   type Middle is limited record
      Given : Faults.Fault_List;
      Next  : Positive := 1;        --  the first replay that has not begun

      Sent  : Message_Vectors.Vector;

      --  Of the message that is being sent: what is left of it, when its
      --  last character came, and which one goes on in its place; 0 is
      --  itself.
      Left  : Natural := 0;
      Last  : Microseconds := 0;
      Shown : Natural := 0;
   end record;

end Sim.Replays;
