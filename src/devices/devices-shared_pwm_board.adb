--  SPDX-License-Identifier: Apache-2.0

package body Devices.Shared_PWM_Board with SPARK_Mode is

   protected body Board is

      procedure Write (Area : Data_Area) is
      begin
         Words := Area;
      end Write;

      function Contents return Data_Area is (Words);

   end Board;

end Devices.Shared_PWM_Board;
