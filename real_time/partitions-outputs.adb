--  SPDX-License-Identifier: Apache-2.0

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;           use GNAT.OS_Lib;

with Host.Complaints; use Host.Complaints;

package body Partitions.Outputs is

   Null_Device : constant String := "/dev/null";

   type Attempt is record
      File    : File_Descriptor := Invalid_FD;
      Existed : Boolean := False;
   end record;
   type Attempt_List is array (Output_File) of Attempt;

   function Place (Name : Unbounded_String) return String is
     (Normalize_Pathname (To_String (Name), Resolve_Links => True));

   function Is_Given (Name : Unbounded_String) return Boolean is
     (Name /= Null_Unbounded_String);

   procedure Check_Distinct (Names : Output_Names);

   --  Deletes what was created.
   procedure Give_Up (Attempts : Attempt_List; Names : Output_Names);

   procedure Check_Distinct (Names : Output_Names) is
   begin
      for Output in Output_File loop
         for Earlier in Output_File'First .. Output loop
            if Earlier /= Output
              and then Is_Given (Names (Output))
              and then Is_Given (Names (Earlier))
              and then Place (Names (Output)) = Place (Names (Earlier))
              and then Place (Names (Output)) /= Null_Device
            then
               Refuse
                 (Name (Output) & " and " & Name (Earlier)
                  & " name the same file");
            end if;
         end loop;
      end loop;
   end Check_Distinct;

   procedure Give_Up (Attempts : Attempt_List; Names : Output_Names) is
      Deleted : Boolean;
   begin
      for Output in Output_File loop
         if Attempts (Output).File /= Invalid_FD then
            Close (Attempts (Output).File);
            if not Attempts (Output).Existed then
               Delete_File (Place (Names (Output)), Deleted);
            end if;
         end if;
      end loop;
   end Give_Up;

   procedure Open (Files : in out File_Set; Names : Output_Names) is
      Attempts : Attempt_List;

      procedure Refuse_Output (Output : Output_File) with No_Return;

      procedure Refuse_Output (Output : Output_File) is
         Reason : constant String := Errno_Message;
      begin
         Give_Up (Attempts, Names);
         Refuse
           (Name (Output) & ": " & Quoted (To_String (Names (Output)))
            & " cannot be created: " & Reason);
      end Refuse_Output;

   begin
      Check_Distinct (Names);

      --  Appending creates a file that is missing and leaves what a file
      --  holds untouched.
      for Output in Output_File loop
         if Is_Given (Names (Output)) then
            Attempts (Output).Existed :=
              Is_Regular_File (To_String (Names (Output)))
              or else Is_Owner_Readable_File (To_String (Names (Output)));
            Attempts (Output).File :=
              Open_Append (To_String (Names (Output)), Binary);
            if Attempts (Output).File = Invalid_FD then
               Refuse_Output (Output);
            end if;
         end if;
      end loop;

      --  All can be written: only now is old content let go.
      for Output in Output_File loop
         if Is_Given (Names (Output)) then
            if Attempts (Output).Existed
              and then Is_Regular_File (To_String (Names (Output)))
            then
               Close (Attempts (Output).File);
               Attempts (Output).File :=
                 Create_File (To_String (Names (Output)), Binary);
               if Attempts (Output).File = Invalid_FD then
                  Refuse_Output (Output);
               end if;
            end if;
            Host.Text_Output.Attach
              (Files (Output), Attempts (Output).File,
               Name (Output) & ": " & Quoted (To_String (Names (Output))));
         end if;
      end loop;
   end Open;

   procedure Close (Files : in out File_Set) is
   begin
      for File of Files loop
         Host.Text_Output.Close (File);
      end loop;
   end Close;

   procedure Rescue (Files : in out File_Set) is
   begin
      for File of Files loop
         begin
            Host.Text_Output.Close (File);
         exception
            when Host.Bad_Input =>
               --  The first thing that went wrong is what is told.
               null;
         end;
      end loop;
   end Rescue;

end Partitions.Outputs;
