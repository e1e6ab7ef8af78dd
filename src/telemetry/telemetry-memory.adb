--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Memory with SPARK_Mode is

   procedure Take_All (Pair : in out Buffer_Pair) is
   begin
      Pair.Slots (First).Full := False;
      Pair.Slots (Second).Full := False;
   end Take_All;

end Telemetry.Memory;
