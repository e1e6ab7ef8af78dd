--  The output files of a flight, opened all together or not at all.
--
--  They are opened after every input was read and checked, the aircraft
--  behind the boards included. If one of them cannot be written, those
--  that existed keep what they held and none is left that did not exist.

with Sim.Options;
with Sim.Text_Output;

package Sim.Outputs is

   --  Writers of outputs that nobody asked for stay closed.
   type File_Set is array (Options.Output_File) of Text_Output.Writer;

   --  Refuses two outputs in one file, an output that is an input, and a
   --  file that cannot be written or created. Folders are not made.
   --  The null device may stand for any number of files.
   procedure Open
     (Files   : in out File_Set;
      Inputs  : Options.Input_Names;
      Outputs : Options.Output_Names);

   --  Raises Bad_Input when what is left to write cannot be written.
   procedure Close (Files : in out File_Set);

end Sim.Outputs;
