--  SPDX-License-Identifier: Apache-2.0

--  All random effects: bit errors (fault "ber"), where each of the nine bits
--  of a character flips with the same probability, independent of all others;
--  and errors of measurements and observations.
--
--  The numbers come from SplitMix64 (Steele, Lea, Flood: Fast Splittable
--  Pseudorandom Number Generators, 2014). All arithmetic is on whole numbers,
--  so that a seed gives the same noise on every machine. A character costs one
--  number where nothing flips.

with Interfaces;

with Sim.Faults;

package Sim.Noise is

   --  A generator of random numbers.
   type Source is private;

   --  The directions of one seed are independent of each other.
   function Seeded (Seed : Seed_Number; Path : Direction) return Source;

   --  The other users of random numbers. They are independent of each other
   --  and of the link's directions.
   type Observer is (The_Sensors, The_Eyes, The_Air);

   function Seeded (Seed : Seed_Number; Viewer : Observer) return Source;

   --  A number near zero with a standard deviation of one: the sum of twelve
   --  uniform ones. Its magnitude is at most six.
   procedure Draw (From : in out Source; Value : out Long_Float);

   --  A whole number that seeds another program.
   function To_Seed (From : Source) return Positive;

   --  A probability in units of 2**-64. One becomes 1 - 2**-64.
   type Level is private;

   function To_Level (Rate : Faults.Probability) return Level;

   --  The flipped bits of the next character.
   procedure Draw
     (From : in out Source;
      Rate : Level;
      Mask : out Faults.Character_Bits);

private

   type Source is new Interfaces.Unsigned_64 with Default_Value => 0;

   --  The probability that the first bit to flip is one of the first N; that a
   --  flipping bit is the first of them.
   type Level is
     array (1 .. Faults.Bits_Of_Character) of Interfaces.Unsigned_64;

end Sim.Noise;
