--  SPDX-License-Identifier: Apache-2.0

--  The number and the echo of an uplink are those with which it was sealed: a
--  step of the proof of Theorems.Seals (SEC-4). It has a file of its own,
--  because only CVC4 proves it, in ten times the steps of the rest.

private package Theorems.Seals.Uplink_Numbers with SPARK_Mode, Ghost is

   --  Consecutive numbers, up to the modulus, have different remainders, so
   --  the latest with a remainder is the number.
   procedure The_Latest_Is_It (Number, Modulus, Most : Counter)
   with
     Global => null,
     Pre    =>
       Modulus in Echo_Modulus | Number_Modulus
       and then Number <= Most
       and then Most - Number < Modulus
       and then Most <= Counter'Last - Number_Modulus,
     Post   => Last_With (Number mod Modulus, Modulus, Most) = Number;

   procedure Uplink_Determines
     (Block  : Block_Data;
      Number : Counter;
      Echo   : Counter;
      Theirs : Session)
   with
     Global => null,
     Pre    =>
       Field_At (Block, Uplink_Words) =
         Word (Number mod Number_Modulus) * Number_Modulus + Code_Of (Echo)
       and then Number <= Latest (Theirs)
       and then Latest (Theirs) - Number < Number_Modulus
       and then Echo <= Theirs.Age
       and then (Echo = 0 or else Theirs.Age - Echo < Echo_Modulus),
     Post   =>
       Number_Of (Block, Ground, Theirs) = Number
       and then Echo_Of (Block, Ground, Theirs) = Echo;

end Theorems.Seals.Uplink_Numbers;
