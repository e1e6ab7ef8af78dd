--  SPDX-License-Identifier: Apache-2.0

--  Claims that are almost true, one at least for each kind of check that
--  the proof of the flight software rests on. They show that the tool is
--  looking: were one of them proved, no other proof would be worth much.
--
--  A line that ends in the name of a check must be the place where
--  GNATprove reports that this check does not hold. All else must be proved.

package Canaries with Pure, SPARK_Mode is
end Canaries;
