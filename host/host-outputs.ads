--  SPDX-License-Identifier: Apache-2.0

--  The output files of a program, opened all together or not at all.
--
--  They are opened after every input was read and checked. If one of them
--  cannot be written, those that existed keep what they held and none is left
--  that did not exist.

with Host.Options; use Host.Options;
with Host.Text_Output;

package Host.Outputs is

   --  The name that means standard output.
   Standard_Output : constant String := "-";

   --  Whether one of the outputs is standard output.
   function Use_Standard_Output (Chosen : Choices) return Boolean is
     (for some Which in Output_Option =>
        Value (Chosen, Which) = Standard_Output);

   --  Writers of outputs that nobody asked for stay closed.
   type File_Set is array (Output_Option) of Text_Output.Writer;

   --  Refuses two outputs in one file, an output that is an input, and a
   --  file that cannot be written or created. Folders are not made.
   --  The null device may stand for any number of files.
   procedure Open (Files : in out File_Set; Chosen : Choices);

   --  Gives up when what is left to write cannot be written.
   procedure Close (Files : in out File_Set);

   --  Closes them after something has gone wrong: what was written so far
   --  stays, as far as it can be.
   procedure Rescue (Files : in out File_Set);

end Host.Outputs;
