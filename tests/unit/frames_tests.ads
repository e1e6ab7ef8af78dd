--  SPDX-License-Identifier: Apache-2.0

--  FRM-1 to FRM-3: ticks, frames and releases.

with AUnit.Test_Suites;

package Frames_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Frames_Tests;
