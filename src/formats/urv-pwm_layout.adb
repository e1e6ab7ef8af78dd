--  SPDX-License-Identifier: Apache-2.0

package body URV.PWM_Layout with SPARK_Mode is

   function To_Data_Area (Source : PWM_Buffer) return Data_Area is
      Result : Data_Area := (others => Neutral);
   begin
      for Item in PWM_Item loop
         Result (Channel_Of (Item)) := Source (Item);
         pragma Loop_Invariant
           (for all Earlier in PWM_Item'First .. Item =>
              Result (Channel_Of (Earlier)) = Source (Earlier));
         pragma Loop_Invariant
           (for all Unused in Channel_Number =>
              (if Unused > Channel_Of (Item)
               then Result (Unused) = Neutral));
      end loop;
      return Result;
   end To_Data_Area;

   function To_Outputs (Area : Data_Area) return PWM_Buffer is
      Result : PWM_Buffer := (others => Word'First);
   begin
      for Item in PWM_Item loop
         Result (Item) := Area (Channel_Of (Item));
         pragma Loop_Invariant
           (for all Earlier in PWM_Item'First .. Item =>
              Result (Earlier) = Area (Channel_Of (Earlier)));
      end loop;
      return Result;
   end To_Outputs;

end URV.PWM_Layout;
