--  SPDX-License-Identifier: Apache-2.0

--  What a partition says while it runs, a line each on standard error. A task
--  of its own writes it: nobody waits for a terminal or a log that is slow
--  (RTP-10).

package Partitions.Notes is

   --  "urv_mcs: What", should anybody read it. For the environment task.
   procedure Print (What : String);

   --  Lines that are whole already.
   procedure Print_Lines (Text : String);

   --  Waits until all is written, for two seconds at most.
   procedure Finish;

end Partitions.Notes;
