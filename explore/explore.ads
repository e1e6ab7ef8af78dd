--  SPDX-License-Identifier: Apache-2.0

--  Exhaustive exploration of the telemetry link: both boards, and what is
--  on the line, as states; one character time as a step.
--
--  docs/exploration.md says what is explored and what is not.

with Telemetry.Checksum;
with Telemetry.Headers; use Telemetry.Headers;
with URVOS;             use URVOS;

package Explore is

   --  Blocks of one byte, both ways.
   Length : constant Block_Length := 1;

   --  The frame of both controllers, in character times: the 9 characters
   --  of an exchange and the 4 that its waits take, and as much time to spare
   --  as in the real frame, 208 less 91 and 4.
   Frame : constant := 126;

   --  From whatever state, both boards are in step again within this time.
   In_Step_Within : constant := 80;

   --  What is on the line for one character time.
   type Symbol is range 0 .. 256;
   Silence : constant Symbol := 0;

   function To_Symbol (Value : Byte) return Symbol is (Symbol (Value) + 1);
   function To_Byte (Value : Symbol) return Byte is (Byte (Value - 1));

   --  A side: a board and what it has on the line. Sides are numbered as
   --  they are found.
   type Side is new Natural;

   --  What a controller does in a character time.
   type Controller_Act is
     (Waits,        --  it gives no block
      Puts_Old,     --  a block that nobody follows
      Puts_Fresh,   --  a block to be followed to the other end
      Does_Either); --  it waits or puts an old block

   --  Where a character time leads: Good tells that a block was received
   --  with a good checksum.
   type Outcome is record
      To   : Side;
      Good : Boolean;
   end record;

   --  The checksum of a block of one byte.
   function Sum_Of (Value : Byte) return Byte is
     (Telemetry.Checksum.Next
        (Telemetry.Checksum.Next
           (Telemetry.Checksum.First_Value, Encode ((Data, Length))),
         Value));

   --  The byte whose checksum that is.
   function Byte_Of (Sum : Byte) return Byte;

   --  The first characters that mean something between the two boards.
   function Has_Meaning (Value : Byte) return Boolean is
     (Value in 16#55# | 16#4B# | 16#D2# | 16#2D# | 16#CC# | 16#33#);

   --  The bytes that a block may hold: 0, which is like no other; those
   --  that look like a first character; those whose checksum does; and that
   --  which is the checksum of a doubled first character.
   function Is_Content (Value : Byte) return Boolean is
     (Value = 0
      or else Has_Meaning (Value)
      or else Has_Meaning (Sum_Of (Value))
      or else Value = Sum_Of (Encode ((Data, Length))));

   --  Every character that a board may send.
   function Is_Sent (Value : Byte) return Boolean is
     (Has_Meaning (Value)
      or else Is_Content (Value)
      or else Is_Content (Byte_Of (Value)));

   --  A checksum that no character sent is equal to.
   function Unlike_All return Byte;

end Explore;
