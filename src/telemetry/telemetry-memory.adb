--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Memory with SPARK_Mode is

   procedure Take
     (Pair  : in out Buffer_Pair;
      Data  : out Block_Data;
      Fresh : out Boolean)
   is
   begin
      Fresh := Any_Full (Pair);
      if Fresh then
         Data := Pair.Slots (Newest_Full (Pair)).Data;
      else
         Data := (others => 0);
      end if;
      Pair.Slots (First).Full := False;
      Pair.Slots (Second).Full := False;
   end Take;

   procedure Put
     (Pair      : in out Buffer_Pair;
      Data      : Block_Data;
      Overwrote : out Boolean)
   is
      Target : constant Slot := To_Fill (Pair);
   begin
      Overwrote := Both_Full (Pair);
      Pair.Slots (Target) :=
        (Full => True, Busy => False, Attempts => 0, Data => Data);
      Pair.Newest := Target;
   end Put;

end Telemetry.Memory;
