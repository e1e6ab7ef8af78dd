--  SPDX-License-Identifier: Apache-2.0

package body URV.Shared_Recorders with SPARK_Mode is

   protected body Recorder is

      procedure Set_Length (Length : Ring_Length) is
      begin
         Kept := (Length => Length, others => <>);
         Phase := (others => <>);
      end Set_Length;

      procedure Clear is
      begin
         Kept := Cleared (Kept);
         Phase := (others => <>);
      end Clear;

      procedure Take (Words : Recorded_Words) is
      begin
         Phase := After (Phase, Words.Sensors);
         if Is_Recording (Phase) and then not Is_Over (Kept) then
            Rows (Kept.Place) := Row_Of (Kept.Next, Words);
            Kept := After (Kept);
         end if;
      end Take;

      procedure Stop is
      begin
         Phase.Is_Asked := True;
      end Stop;

      function Contents return Ring is (Kept);

      function Row_At (Number : Row_Number) return Row is
        (if Is_Held (Kept, Number) then Rows (Place_Of (Kept, Number))
         else (others => <>));

   end Recorder;

end URV.Shared_Recorders;
