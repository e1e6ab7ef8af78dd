--  SPDX-License-Identifier: Apache-2.0

--  An attacker in the middle of the line who cannot make messages: the
--  attacker replaces a sent message by an earlier one of the same direction
--  (SIM-2, SEC-4). Messages from a constant number of messages back delay the
--  line; varying numbers withhold, repeat and reorder messages.

with Sim.Faults;
with URVOS; use URVOS;

private with Ada.Containers.Vectors;
private with Telemetry;

package Sim.Replays is

   type Middle is limited private;

   --  Takes over the replays of a direction. Without any, nothing changes.
   procedure Prepare
     (Made : in out Middle; Given : Faults.Fault_List);

   --  A character is sent at that time; Data becomes the forwarded one. Time
   --  must not decrease.
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

      --  The message being sent: its remaining length, the time of its last
      --  character, and the message forwarded in its place; 0 is itself.
      Left  : Natural := 0;
      Last  : Microseconds := 0;
      Shown : Natural := 0;
   end record;

end Sim.Replays;
