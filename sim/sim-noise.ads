--  SPDX-License-Identifier: Apache-2.0

--  What happens by chance. Bit errors (fault "ber"): each of the nine bits of
--  a character flips with the same probability, independent of all others.
--  And errors of what is measured or seen.
--
--  The numbers come from SplitMix64 (Steele, Lea, Flood: Fast Splittable
--  Pseudorandom Number Generators, 2014). All arithmetic is on whole
--  numbers, so that a seed gives the same noise on every machine. A
--  character costs one number where nothing flips.

with Interfaces;

with Sim.Faults;

package Sim.Noise is

   --  Where the numbers come from.
   type Source is private;

   --  Two directions of one seed have nothing to do with each other.
   function Seeded (Seed : Seed_Number; Way : Direction) return Source;

   --  Whose errors are drawn besides. They have nothing to do with each
   --  other, nor with a direction of the link.
   type Observer is (The_Sensors, The_Eyes, The_Air);

   function Seeded (Seed : Seed_Number; Whose : Observer) return Source;

   --  A number near zero with a standard deviation of one: the sum of twelve
   --  even ones. It is never beyond six.
   procedure Draw (From : in out Source; Value : out Long_Float);

   --  A whole number that seeds another program.
   function To_Seed (From : Source) return Positive;

   --  What a probability comes to, in units of 2**-64. One becomes
   --  1 - 2**-64.
   type Level is private;

   function To_Level (Rate : Faults.Probability) return Level;

   --  The flipped bits of the next character.
   procedure Draw
     (From : in out Source;
      Rate : Level;
      Mask : out Faults.Character_Bits);

private

   type Source is new Interfaces.Unsigned_64 with Default_Value => 0;

   --  The chance that the first bit to flip is one of the first N; that a
   --  bit flips is the first of them.
   type Level is
     array (1 .. Faults.Bits_Of_Character) of Interfaces.Unsigned_64;

end Sim.Noise;
