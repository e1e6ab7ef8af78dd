--  SPDX-License-Identifier: Apache-2.0

package body Law_Suite is

   package body Laws_Tests is separate;

   package body Console_Watch_Tests is separate;

   package body LAW_Task_Tests is separate;

   package body PWM_Tests is separate;

   package body Surfaces_Tests is separate;

   package body Test_Cards_Tests is separate;

end Law_Suite;
