--  SPDX-License-Identifier: Apache-2.0

package body URV.Servo_Models with SPARK_Mode is

   function Left_After_Five
     (Distance : Short_Distance; Slowest : Rate_Limit) return Short_Distance
   is
      First : constant Number := Integer (Distance) with Ghost;
      Rest  : Short_Distance := Distance;
   begin
      for Step in 1 .. Steps_Per_Frame loop
         Rest := Rest - Short_Distance
           (Integer'Min (Slowest, Share_Of (Rest)));
         pragma Loop_Invariant (Rest <= Distance);
         pragma Loop_Invariant
           (Integer (Rest) =
              (case Step is
                  when 1 => Left (First, Slowest),
                  when 2 => Left_After_Two (First, Slowest),
                  when 3 =>
                    Left (Left_After_Two (First, Slowest), Slowest),
                  when 4 =>
                    Left_After_Two
                      (Left_After_Two (First, Slowest), Slowest),
                  when others =>
                    Left
                      (Left_After_Two
                         (Left_After_Two (First, Slowest), Slowest),
                       Slowest)));
      end loop;
      return Rest;
   end Left_After_Five;

end URV.Servo_Models;
