--  SPDX-License-Identifier: Apache-2.0

--  What a partition says while it runs, a line each on standard error.

package Partitions.Notes is

   --  "urv_mcs: What", should anybody read it.
   procedure Print (What : String);

end Partitions.Notes;
