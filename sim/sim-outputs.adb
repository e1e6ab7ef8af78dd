--  SPDX-License-Identifier: Apache-2.0

with Ada.Directories;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;           use GNAT.OS_Lib;

with Host.Complaints; use Host.Complaints;
with Sim.Options;     use Sim.Options;

package body Sim.Outputs is

   Null_Device : constant String := "/dev/null";

   --  What was found of an output on the way to opening it.
   type Attempt is record
      File    : File_Descriptor := Invalid_FD;
      Existed : Boolean := False;
   end record;
   type Attempt_List is array (Output_File) of Attempt;

   --  The file that a name means, symbolic links followed.
   function Place (Name : Unbounded_String) return String;

   --  Do both names mean one file, and not the null device?
   function Same_File (Left, Right : Unbounded_String) return Boolean;

   procedure Check_Distinct
     (Inputs  : Input_Names;
      Outputs : Output_Names);

   --  Opens a file as it is, or creates it.
   procedure Try (Name : String; Made : out Attempt);

   --  Takes everything back.
   procedure Give_Up
     (Attempts : Attempt_List;
      Outputs  : Output_Names);

   function Is_Standard_Output (Name : Unbounded_String) return Boolean is
     (Name = Standard_Output);

   function Use_Standard_Output (Outputs : Options.Output_Names)
                                 return Boolean
   is (for some Name of Outputs => Is_Standard_Output (Name));

   function Place (Name : Unbounded_String) return String is
     (if Is_Standard_Output (Name) then Standard_Output
      else Normalize_Pathname (To_String (Name), Resolve_Links => True));

   function Same_File (Left, Right : Unbounded_String) return Boolean is
     (Left /= Null_Unbounded_String
      and then Right /= Null_Unbounded_String
      and then Place (Left) = Place (Right)
      and then Place (Left) /= Null_Device);

   procedure Check_Distinct
     (Inputs  : Input_Names;
      Outputs : Output_Names)
   is
      procedure Refuse_Pair (Option : String; Earlier : String)
        with No_Return;

      procedure Refuse_Pair (Option : String; Earlier : String) is
      begin
         Refuse (Option & " and " & Earlier & " name the same file");
      end Refuse_Pair;
   begin
      for Output in Output_File loop
         for Input in Input_File loop
            if not Is_Standard_Output (Outputs (Output))
              and then Same_File (Outputs (Output), Inputs (Input))
            then
               Refuse_Pair (Name (Output), Name (Input));
            end if;
         end loop;
         for Earlier in Output_File'First .. Output loop
            if Earlier /= Output
              and then Same_File (Outputs (Output), Outputs (Earlier))
            then
               Refuse_Pair (Name (Output), Name (Earlier));
            end if;
         end loop;
      end loop;
   end Check_Distinct;

   procedure Try (Name : String; Made : out Attempt) is
   begin
      if Name = Standard_Output then
         Made := (File => Text_Output.Screen, Existed => True);
         return;
      end if;

      --  Appending creates a file that is missing and leaves what a file
      --  holds untouched.
      Made.Existed := Ada.Directories.Exists (Name);
      Made.File    := Open_Append (Name, Binary);
   end Try;

   procedure Give_Up
     (Attempts : Attempt_List;
      Outputs  : Output_Names)
   is
      Deleted : Boolean;
   begin
      for Output in Output_File loop
         if Attempts (Output).File /= Invalid_FD then
            Close (Attempts (Output).File);
            if not Attempts (Output).Existed then
               --  A link to nothing now leads to the file to delete.
               Delete_File (Place (Outputs (Output)), Deleted);
            end if;
         end if;
      end loop;
   end Give_Up;

   procedure Open
     (Files   : in out File_Set;
      Inputs  : Input_Names;
      Outputs : Output_Names)
   is
      Attempts : Attempt_List;

      procedure Refuse_Output (Output : Output_File) with No_Return;

      procedure Refuse_Output (Output : Output_File) is
         Reason : constant String := Errno_Message;
      begin
         Give_Up (Attempts, Outputs);
         Refuse
           (Name (Output) & ": " & Quoted (To_String (Outputs (Output)))
            & " cannot be created: " & Reason);
      end Refuse_Output;

   begin
      Check_Distinct (Inputs, Outputs);

      for Output in Output_File loop
         if Outputs (Output) /= Null_Unbounded_String then
            Try (To_String (Outputs (Output)), Attempts (Output));
            if Attempts (Output).File = Invalid_FD then
               Refuse_Output (Output);
            end if;
         end if;
      end loop;

      --  All can be written. Only now is old content let go. Devices and
      --  pipes hold none, and a pipe's reader would see it close.
      for Output in Output_File loop
         if Attempts (Output).Existed
           and then not Is_Standard_Output (Outputs (Output))
           and then Is_Regular_File (To_String (Outputs (Output)))
         then
            Close (Attempts (Output).File);
            Attempts (Output).File :=
              Create_File (To_String (Outputs (Output)), Binary);
            if Attempts (Output).File = Invalid_FD then
               Refuse_Output (Output);
            end if;
         end if;

         if Attempts (Output).File /= Invalid_FD then
            Text_Output.Attach
              (Files (Output), Attempts (Output).File,
               Name (Output) & ": "
               & (if Is_Standard_Output (Outputs (Output))
                  then "standard output"
                  else Quoted (To_String (Outputs (Output)))));
         end if;
      end loop;
   end Open;

   procedure Close (Files : in out File_Set) is
   begin
      for File of Files loop
         Text_Output.Close (File);
      end loop;
   end Close;

   procedure Rescue (Files : in out File_Set) is
   begin
      for File of Files loop
         begin
            Text_Output.Close (File);
         exception
            when Bad_Input =>
               --  The first thing that went wrong is what is told.
               null;
         end;
      end loop;
   end Rescue;

end Sim.Outputs;
