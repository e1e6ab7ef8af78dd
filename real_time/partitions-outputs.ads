--  SPDX-License-Identifier: Apache-2.0

--  The output files of a partition, opened all together or not at all.

with Host.Text_Output;
with Partitions.Options; use Partitions.Options;

package Partitions.Outputs is

   type File_Set is array (Output_File) of Host.Text_Output.Writer;

   --  Refuses two outputs in one file and a file that cannot be written or
   --  created: raises Host.Bad_Input. What existed then keeps what it held.
   procedure Open (Files : in out File_Set; Names : Output_Names);

   --  Raises Host.Bad_Input when what is left to write cannot be written.
   procedure Close (Files : in out File_Set);

   --  Writes what can still be written, once one of them could not be.
   procedure Rescue (Files : in out File_Set);

end Partitions.Outputs;
