--  SPDX-License-Identifier: Apache-2.0

--  The memory of the flight recorder (FTI-9), in rows of about 150
--  bytes, in the 64 KiB of RAM (image.ld).

package URV.Recorder_Sizes with Pure, SPARK_Mode is

   --  1.28 s of major frames, 9 KiB.
   Most_Rows : constant := 64;

end URV.Recorder_Sizes;
