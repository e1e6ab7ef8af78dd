--  SPDX-License-Identifier: Apache-2.0

--  The messages of a running partition, one line each on standard error. A
--  separate task writes them: no other task waits for a slow terminal or log
--  (RTP-10).

package Partitions.Notes is

   --  Prints "urv_mcs: What". For the environment task.
   procedure Print (Message : String);

   --  Prints complete lines.
   procedure Print_Lines (Text : String);

   --  Waits until all is written, for two seconds at most.
   procedure Finish;

end Partitions.Notes;
