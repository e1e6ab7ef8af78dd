--  SPDX-License-Identifier: Apache-2.0

--  FRM-1, FRM-4, KRN-1 to KRN-3: the times at which tasks run if their steps
--  take time.

with AUnit.Test_Suites;

package Clocked_Executives_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Clocked_Executives_Tests;
