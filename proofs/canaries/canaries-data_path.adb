--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Data_Path with SPARK_Mode is

   procedure Roll_Reaches_The_Aileron (Commands : Uplink_Buffer) is null;

   procedure Low_Byte_Comes_First (High, Low : Byte) is null;

   procedure Clock_Runs (Now : Clock_Tick) is null;

end Canaries.Data_Path;
