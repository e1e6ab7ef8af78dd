--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Memory with SPARK_Mode is

   procedure Take_All (Pair : in out Buffer_Pair) is
   begin
      Pair.Slots (First).Full := False;
      Pair.Slots (Second).Full := False;
   end Take_All;

   procedure Release (Pair : in out Buffer_Pair) is
   begin
      Pair.Slots (First).Busy := False;
      Pair.Slots (Second).Busy := False;
   end Release;

   procedure Settle
     (Pair  : in out Buffer_Pair;
      Which : Slot;
      Block : Delivery) is
   begin
      if Block /= Open then
         if Block = Confirmed or else Is_Scrapped (Pair, Which, Block) then
            Pair.Slots (Which).Full := False;
            Pair.Slots (Which).Attempts := 0;
         end if;
         Pair.Slots (Which).Busy := False;
      end if;
   end Settle;

   procedure Begin_Block (Pair : in out Buffer_Pair; Which : Slot) is
   begin
      Pair.Slots (Which).Busy := True;
      Pair.Slots (Which).Attempts := Pair.Slots (Which).Attempts + 1;
      if Pair.Slots (Other (Which)).Full then
         Pair.Slots (Other (Which)).Full := False;
         Pair.Slots (Other (Which)).Attempts := 0;
      end if;
   end Begin_Block;

end Telemetry.Memory;
