--  SPDX-License-Identifier: Apache-2.0

--  The outputs of a partition. Each has a writing task of its own, so that
--  neither the node, nor its reports, nor another output wait for a disk. An
--  output that cannot be written is reported and closed; the run continues
--  (RTP-10).
--
--  For the environment task.

with Host.Options; use Host.Options;
with URVOS;

package Partitions.Output_Files is

   subtype Kept is Output_Option
     with Static_Predicate => Kept not in Wire_Option | Fetched_Option;

   --  Opens the requested outputs. Raises Host.Bad_Input.
   procedure Open (Chosen : Choices);

   function Is_Open (Which : Kept) return Boolean;

   --  True if the file can be rewritten from its beginning.
   function Can_Restart (Which : Kept) return Boolean
     with Pre => Is_Open (Which);

   --  The outputs that grow by rows.
   subtype Growing is Output_Option range Record_Option .. Recording_Option;

   --  Puts rows, each with the end of its line. Rows without room, or without
   --  a file, are counted and left out.
   procedure Put_Row (Text : String; Which : Growing := Record_Option)
     with Pre => Is_Open (Which);
   function Rows_Left_Out (Which : Growing) return URVOS.Count;

   --  There is room for many rows.
   function Has_Room (Which : Growing) return Boolean;

   --  Writes the rows so far to the file, those of a recording to its disk
   --  (FTI-11).
   procedure Write_Rows (Which : Growing := Record_Option)
     with Pre => Is_Open (Which);

   --  Replaces the whole contents of the file.
   procedure Put_Version (Which : Kept; Text : String)
     with Pre => Is_Open (Which);

   --  Prints on standard output.
   procedure Print (Text : String);

   --  Closes the file when all is written. A file that accepts no text for
   --  three seconds is reported and lost.
   procedure Finish (Which : Kept);
   procedure Finish_Printing;

   function Is_Lost (Which : Kept) return Boolean;

   --  True if any output is incomplete, standard output included.
   function Any_Lost return Boolean;

end Partitions.Output_Files;
