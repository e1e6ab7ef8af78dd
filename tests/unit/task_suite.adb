--  SPDX-License-Identifier: Apache-2.0

package body Task_Suite is

   package body Exchange_Tests is separate;

   package body Task_Shells_Tests is separate;

   package body Telemetry_Task_Tests is separate;

   package body Type_Codes_Tests is separate;

   package body AD_Tests is separate;

   package body CORE_Tests is separate;

   package body LOG_Task_Tests is separate;

   package body Recorder_Tests is separate;

   package body Serial_Line_Tests is separate;

   package body Flood_Tests is separate;

   package body Output_Buffers_Tests is separate;

   package body Peer_Watch_Tests is separate;

end Task_Suite;
