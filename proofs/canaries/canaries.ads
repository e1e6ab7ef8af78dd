--  SPDX-License-Identifier: Apache-2.0

--  Claims that are almost true, at least one for each kind of check on which
--  the flight software's proof rests. They show that the tool really checks:
--  if one of them were proved, no other proof could be trusted.
--
--  A line that ends in the name of a check is the place where GNATprove must
--  report that this check fails. It must prove all else.

package Canaries with Pure, SPARK_Mode is
end Canaries;
