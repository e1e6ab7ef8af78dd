--  SPDX-License-Identifier: Apache-2.0

package body Node_Suite is

   package body Shared_Nodes_Tests is separate;

   package body Real_Time_Nodes_Tests is separate;

   package body Guarded_Step_Tests is separate;

   package body Starts_Tests is separate;

   package body In_Flight_Tests is separate;

   package body Self_Test_Tests is separate;

end Node_Suite;
