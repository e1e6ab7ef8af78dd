--  SPDX-License-Identifier: Apache-2.0

with Ada.Directories;
with GNAT.OS_Lib;  use GNAT.OS_Lib;
with Interfaces.C; use Interfaces.C;

with Host.Complaints; use Host.Complaints;
with Host.File_States;

package body Host.Outputs is

   Null_Device : constant String := "/dev/null";

   --  The operating system: Linux. An output whose name is a symbolic link is
   --  not opened, even if the link was made a moment ago (SEC-15, D-66).

   To_Write       : constant := 1;
   Creating       : constant := 8#100#;
   Following_None : constant := 8#400_000#;
   Close_On_Exec  : constant := 8#2_000_000#;
   For_All        : constant := 8#666#;

   function Open (Name : char_array; Flags : int; Mode : unsigned) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   function Truncate
     (File : File_Descriptor; Length : Long_Long_Integer) return int
   with Import, Convention => C, External_Name => "ftruncate64";

   --  The program's own descriptors have such names. They are links, but only
   --  the program can change them.
   function Begins (Text, Beginning : String) return Boolean is
     (Text'Length >= Beginning'Length
      and then Text (Text'First .. Text'First + Beginning'Length - 1)
               = Beginning);

   function Is_Own_Descriptor (Name : String) return Boolean;

   --  The result of trying to open an output.
   type Attempt is record
      File    : File_Descriptor := Invalid_FD;
      Existed : Boolean := False;
   end record;
   type Attempt_List is array (Output_Option) of Attempt;

   --  The file that a name denotes, after symbolic links.
   function Place (Name : String) return String;

   --  True if both paths denote one file, other than the null device: after
   --  symbolic links, or as hard links of a regular file.
   function Same_File (Left, Right : String) return Boolean;
   function Are_Hard_Links (Left, Right : String) return Boolean;

   --  The path of an output's file, also of standard output.
   function Path (Output : String) return String is
     (if Output = Standard_Output then "/proc/self/fd/1" else Output);

   --  True if both outputs go to one file.
   function Are_Joined (Left, Right : String) return Boolean;

   procedure Check_Distinct (Chosen : Choices);

   --  Opens a file as it is, or creates it.
   procedure Try (Name : String; Made : out Attempt);

   --  Undoes all attempts.
   procedure Give_Up (Attempts : Attempt_List; Chosen : Choices);

   function Is_Input (Which : Option) return Boolean is
     (Which not in Output_Option and then Value_Name (Which) = "FILE");

   function Is_Own_Descriptor (Name : String) return Boolean is
     (Name in "/dev/stdout" | "/dev/stderr"
      or else Begins (Name, "/dev/fd/")
      or else Begins (Name, "/proc/self/fd/"));

   function Place (Name : String) return String is
     (Normalize_Pathname (Name, Resolve_Links => True));

   function Are_Hard_Links (Left, Right : String) return Boolean is
      use File_States;
      One, Other         : State;
      Has_One, Has_Other : Boolean;
   begin
      Read (Left, Has_One, One);
      Read (Right, Has_Other, Other);
      return
        Has_One and then Has_Other and then Is_Regular (One)
        and then Is_One_File (One, Other);
   end Are_Hard_Links;

   function Same_File (Left, Right : String) return Boolean is
     (Left /= ""
      and then Right /= ""
      and then Place (Left) /= Null_Device
      and then (Place (Left) = Place (Right)
                or else Are_Hard_Links (Left, Right)));

   function Are_Joined (Left, Right : String) return Boolean is
     ((Left = Standard_Output and then Right = Standard_Output)
      or else Same_File (Path (Left), Path (Right)));

   procedure Check_Distinct (Chosen : Choices) is
   begin
      for Output in Output_Option loop
         for Other in Option range Option'First .. Output loop
            if (Is_Input (Other)
                and then Same_File
                  (Path (Value (Chosen, Output)), Value (Chosen, Other)))
              or else
                (Other in Output_Option and then Other /= Output
                 and then Are_Joined
                   (Value (Chosen, Output), Value (Chosen, Other)))
            then
               Refuse
                 (Name (Output) & " and " & Name (Other)
                  & " name the same file");
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

      --  Creates a missing file and leaves existing contents untouched.
      Made.Existed := Ada.Directories.Exists (Name);
      Made.File    := File_Descriptor
        (Open
           (To_C (Name),
            To_Write + Creating + Close_On_Exec
            + (if Is_Own_Descriptor (Name) then 0 else Following_None),
            For_All));
   end Try;

   procedure Give_Up (Attempts : Attempt_List; Chosen : Choices) is
      Deleted : Boolean;
   begin
      for Output in Output_Option loop
         if Attempts (Output).File /= Invalid_FD then
            Close (Attempts (Output).File);
            if not Attempts (Output).Existed then
               Delete_File (Value (Chosen, Output), Deleted);
            end if;
         end if;
      end loop;
   end Give_Up;

   procedure Open (Files : in out File_Set; Chosen : Choices) is
      Attempts : Attempt_List;

      procedure Refuse_Output (Output : Output_Option) with No_Return;

      procedure Refuse_Output (Output : Output_Option) is
         --  Before any other call changes it.
         Error  : constant Integer := Errno;
         Reason : constant String :=
           (if Is_Symbolic_Link (Value (Chosen, Output))
              and then not Is_Own_Descriptor (Value (Chosen, Output))
            then "it is a symbolic link"
            else Errno_Message (Error));
      begin
         Give_Up (Attempts, Chosen);
         Refuse
           (Name (Output) & ": " & Quoted (Value (Chosen, Output))
            & " cannot be created: " & Reason);
      end Refuse_Output;

   begin
      Check_Distinct (Chosen);

      for Output in Output_Option loop
         if Is_Given (Chosen, Output) then
            Try (Value (Chosen, Output), Attempts (Output));
            if Attempts (Output).File = Invalid_FD then
               Refuse_Output (Output);
            end if;
         end if;
      end loop;

      --  All files can be written: only now is old content discarded. Devices
      --  and pipes hold none, and a pipe's reader would see it close.
      for Output in Output_Option loop
         declare
            Name      : constant String  := Value (Chosen, Output);
            Is_Screen : constant Boolean := Name = Standard_Output;
         begin
            if Attempts (Output).File /= Invalid_FD
              and then not Is_Screen
              and then Is_Regular_File (Name)
              and then Truncate (Attempts (Output).File, 0) /= 0
            then
               Refuse_Output (Output);
            end if;

            if Attempts (Output).File /= Invalid_FD then
               Text_Output.Attach
                 (Files (Output), Attempts (Output).File,
                  Options.Name (Output) & ": "
                  & (if Is_Screen then "standard output" else Quoted (Name)),
                  Is_Rewritten =>
                    not Is_Screen and then Is_Regular_File (Name));
            end if;
         end;
      end loop;
   end Open;

   procedure Flush (Files : in out File_Set; Except : Output_Option) is
   begin
      for Output in Output_Option loop
         if Output /= Except and then Text_Output.Is_Open (Files (Output)) then
            Text_Output.Flush (Files (Output));
         end if;
      end loop;
   end Flush;

   procedure Close (Files : in out File_Set) is
   begin
      for File of Files loop
         Text_Output.Close (File);
      end loop;
   end Close;

end Host.Outputs;
