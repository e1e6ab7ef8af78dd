--  SPDX-License-Identifier: Apache-2.0

--  The output files of a program, opened all together or not at all.
--
--  They are opened after every input was read and checked. If one of them
--  cannot be written, existing files keep their contents and no new file
--  remains. If one fails later, only that one is lost (SIM-8).

with Host.Options; use Host.Options;
with Host.Text_Output;

package Host.Outputs is

   --  The name that means standard output.
   Standard_Output : constant String := "-";

   --  True if one of the outputs is standard output.
   function Use_Standard_Output (Chosen : Choices) return Boolean is
     (for some Which in Output_Option =>
        Value (Chosen, Which) = Standard_Output);

   --  Writers of outputs that were not requested stay closed.
   type File_Set is array (Output_Option) of Text_Output.Writer;

   --  Refuses two outputs in one file, an output that is an input, one that is
   --  a symbolic link (SEC-15), and a file that cannot be written or created.
   --  Folders are not made.
   --  Any number of outputs may go to the null device.
   procedure Open (Files : in out File_Set; Chosen : Choices);

   --  Writes all buffered output except that of one file.
   procedure Flush (Files : in out File_Set; Except : Output_Option);

   --  True if the reader of an output on standard output has closed it: that
   --  ends a simulated flight (D-55).
   function Is_Unread (Files : File_Set; Chosen : Choices) return Boolean is
     (for some Which in Output_Option =>
        Value (Chosen, Which) = Standard_Output
        and then Text_Output.Is_Unread (Files (Which)));

   --  Writes the buffered output, as far as possible, and closes the files.
   procedure Close (Files : in out File_Set);

end Host.Outputs;
