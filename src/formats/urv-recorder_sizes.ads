--  SPDX-License-Identifier: Apache-2.0

--  The memory of the flight recorder (FTI-9), in rows of about 160
--  bytes. Small targets have a file of their own in the place of this one.

package URV.Recorder_Sizes with Pure, SPARK_Mode is

   --  10 minutes of major frames.
   Most_Rows : constant := 30_000;

end URV.Recorder_Sizes;
