--  SPDX-License-Identifier: Apache-2.0

--  Exhaustive exploration of the telemetry link: both boards, and what is
--  on the line, as states; one character time as a step.
--
--  docs/evidence/exploration.md says what is explored and what is not.

with Telemetry;         use Telemetry;
with Telemetry.Headers; use Telemetry.Headers;

package Explore is

   --  The bytes of a block, by who sends it.
   type Block_Lengths is array (Station) of Block_Length;

   --  The flight software's values.
   Real_Lengths : constant Block_Lengths :=
     (Ground => Uplink_Length, Aircraft => Downlink_Length);

   --  From now on blocks are of these lengths, which the program is told
   --  when it starts.
   procedure Set_Lengths (Lengths : Block_Lengths);

   function Length_Of (Sender : Station) return Block_Length;

   --  And both boards wait for a line with that round trip (LNK-11), though
   --  the one that is explored has none.
   procedure Set_Round_Trip (Time : Round_Trip_Time);

   function Round_Trip return Round_Trip_Time;

   --  The characters of an exchange, and the most that its two guard times
   --  take.
   function Exchange return Positive is
     (Positive (Length_Of (Ground)) + Positive (Length_Of (Aircraft)) + 7);
   Guard_Times : constant := 4;

   --  The frame of both controllers, in character times. The real one has
   --  208; one with shorter blocks has as much time to spare.
   To_Spare : constant := 113;
   function Frame return Positive is (Exchange + Guard_Times + To_Spare);

   --  From whatever state, both boards are in step again within this time.
   function In_Step_Within return Positive is
     (4 * Exchange + 44 + 4 * Natural (Round_Trip));

   --  The line during a character time. A byte of a block, or its checksum,
   --  may look like anything to who does not take it for that, so which byte
   --  it is is no part of a state.
   type Symbol is
     (Silence,
      Data_Begins,   --  the first character of a data message
      Data_Goes_On,  --  a byte of its block
      Data_Ends,     --  its checksum
      Command,
      Good, Good_And_Wants,
      Bad, Bad_And_Wants);
   subtype Wild_Symbol is Symbol range Data_Goes_On .. Data_Ends;

   --  A side: a board and what it has on the line. Sides are numbered as
   --  they are found.
   type Side is new Natural;

   --  A controller's action in a character time.
   type Controller_Act is
     (Waits,        --  it gives no block
      Puts_Old,     --  a block that nobody follows
      Puts_Fresh,   --  a block to be followed to the other end
      Does_Either); --  it waits or puts an old block

   --  The result of a character time: Good reports that a message was received
   --  whole, from its first character to its last.
   type Outcome is record
      To   : Side;
      Good : Boolean;
   end record;

end Explore;
