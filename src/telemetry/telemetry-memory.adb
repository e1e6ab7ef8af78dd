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

   procedure Fill (Pair : in out Buffer_Pair; Data : Block_Data) is
      Which : constant Slot := To_Fill (Pair);
   begin
      Pair.Slots (Which).Data := Data;
      Pair.Slots (Which).Full := True;
      Pair.Slots (Which).Busy := False;
      Pair.Slots (Which).Attempts := 0;
      Pair.Newest := Which;
   end Fill;

   procedure Copy_Contents (Pair : Buffer_Pair; Data : out Block_Data) is
   begin
      if Any_Full (Pair) then
         Data := Pair.Slots (Newest_Full (Pair)).Data;
      else
         Data := (others => 0);
      end if;
   end Copy_Contents;

end Telemetry.Memory;
