with Ada.Exceptions;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;
with GNAT.OS_Lib;

with Partitions.Clocks;
with Partitions.Links;
with Partitions.Outputs;    use Partitions.Outputs;
with Partitions.Rows;       use Partitions.Rows;
with Sim;
with Sim.Complaints;
with Sim.Text_Numbers;

procedure Partitions.Run is

   use Sim.Text_Output;
   use type Number;

   Files  : File_Set;
   Frames : Number := 0;

   --  The partition ends. Its other tasks do not: Ravenscar.
   procedure Leave (Status : Integer) with No_Return;

   --  Writes a row for each frame until the partition is switched off.
   procedure Write_Rows (Last_Frame : Number);

   procedure Write_Summary;

   procedure Print_Summary;

   procedure Leave (Status : Integer) is
   begin
      GNAT.OS_Lib.OS_Exit (Status);
   end Leave;

   procedure Write_Rows (Last_Frame : Number) is
      Item  : Row;
      Found : Boolean;
   begin
      loop
         Queue.Take (Item, Found);
         exit when not Found;
         Frames := Item.Value (1) + 1;
         if Is_Open (Files (Record_File)) then
            for Place in 1 .. Item.Length loop
               if Place > 1 then
                  Put (Files (Record_File), ',');
               end if;
               Put (Files (Record_File), Item.Value (Place));
            end loop;
            New_Line (Files (Record_File));
         end if;
         exit when Last_Frame > 0 and then Frames >= Last_Frame;
      end loop;
      Queue.Finish;
   end Write_Rows;

   procedure Write_Summary is
      Result : Reports.Report;
      To     : Writer renames Files (Summary_File);
   begin
      Reports.Begin_Report (Result, To);
      Reports.Put_Field (Result, To, "seconds", Frames * 2, 2);
      Reports.Put_Field (Result, To, "frames", Frames);
      Reports.Put_Field
        (Result, To, "overruns", Number (Overruns));
      Reports.Put_Field
        (Result, To, "switched_on_us",
         Number (Clocks.Machine_Time (Clocks.Switched_On_At)));
      Reports.Put_Field
        (Result, To, "characters_not_sent", Number (Links.Not_Sent));
      Reports.Put_Field
        (Result, To, "rows_left_out", Number (Queue.Left_Out));
      Put_Results (To, Result);
      Reports.End_Report (Result, To);
   end Write_Summary;

   procedure Print_Summary is
      use Ada.Text_IO;
      use Sim.Text_Numbers;
   begin
      Put_Line
        ("run       " & Image (Long_Long_Integer (Frames / 50)) & " s, "
         & Image (Long_Long_Integer (Frames)) & " frames, "
         & Image (Long_Long_Integer (Overruns)) & " overruns");
      Flush;
   end Print_Summary;

   Chosen : Choices;

begin
   Chosen := Parsed (This);
   if Chosen.Help then
      Print_Usage (This);
      Ada.Text_IO.Flush;
      Leave (0);
   end if;

   if Chosen.Script /= Null_Unbounded_String then
      Load_Script (To_String (Chosen.Script));
   end if;
   Links.Open (To_String (Chosen.Link));
   Outputs.Open (Files, Chosen.Outputs);
   if Is_Open (Files (Record_File)) then
      Put
        (Files (Record_File),
         "frame,time_ms" & Column_Names & ",overruns,clock_us");
      New_Line (Files (Record_File));
   end if;

   if Chosen.In_Phase then
      Clocks.Await_Phase (Chosen.Phase);
   end if;
   Clocks.Switch_On;
   Switch_On;
   Write_Rows (Number (Chosen.Frames));

   if Is_Open (Files (Summary_File)) then
      Write_Summary;
   end if;
   if Is_Open (Files (Events_File)) then
      Put_Events (Files (Events_File));
   end if;
   Outputs.Close (Files);
   if not Chosen.Quiet then
      Print_Summary;
   end if;
   Leave (0);

exception
   when Error : Sim.Bad_Input =>
      Sim.Complaints.Print (Error);
      Leave (2);

   when Error : others =>
      Ada.Text_IO.Put_Line
        (Ada.Text_IO.Standard_Error,
         "internal fault: " & Ada.Exceptions.Exception_Information (Error));
      Leave (1);
end Partitions.Run;
