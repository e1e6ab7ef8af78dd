--  SPDX-License-Identifier: Apache-2.0

with Ada.Command_Line;
with Ada.Directories;
with Ada.Environment_Variables;

with Host.Complaints;
with Host.Text_Numbers;

package body Host.Plant_Program is

   Interpreter_Variable : constant String := "URV_PYTHON";
   Interpreter_Path     : constant String := "/.venv/bin/python";
   Script_Path          : constant String := "/sim/jsbsim/plant.py";

   --  The C library computes sines with fused multiply-add where the processor
   --  has it, and the last bit differs. Without it every processor gives the
   --  same flight.
   Library_Variable : constant String := "GLIBC_TUNABLES";
   Library_Setting  : constant String := "glibc.cpu.hwcaps=-FMA,-FMA4";

   --  The directory above that of the running program, after symbolic links.
   function Project_Directory return String;

   function Interpreter (Home : String) return String;

   procedure Refuse (Why : String) is
   begin
      Refuse_Flight (Why & "; `make fly` sets it up");
   end Refuse;

   procedure Refuse_Flight (Answer : String) is
   begin
      Complaints.Refuse ("--plant jsbsim: " & Answer);
   end Refuse_Flight;

   function Project_Directory return String is
      Command : constant String := Ada.Command_Line.Command_Name;
      Found   : String_Access   := Locate_Exec_On_Path (Command);
      Path    : constant String :=
        Normalize_Pathname (if Found = null then Command else Found.all);
   begin
      Free (Found);
      return
        Ada.Directories.Containing_Directory
          (Ada.Directories.Containing_Directory (Path));
   end Project_Directory;

   function Interpreter (Home : String) return String is
   begin
      if not Ada.Environment_Variables.Exists (Interpreter_Variable) then
         return Home & Interpreter_Path;
      end if;

      declare
         Named : constant String :=
           Ada.Environment_Variables.Value (Interpreter_Variable);
         Found : String_Access   := Locate_Exec_On_Path (Named);
         Path  : constant String :=
           (if Found = null then Named else Found.all);
      begin
         Free (Found);
         return Path;
      end;
   end Interpreter;

   procedure Spawn (Descriptor : Natural; Process : out Process_Id) is
      Home   : constant String := Project_Directory;
      Python : constant String := Interpreter (Home);
      Script : constant String := Home & Script_Path;
   begin
      if not Is_Executable_File (Python) then
         Refuse ("no Python at " & Python);
      elsif not Is_Regular_File (Script) then
         Refuse ("no file " & Script);
      end if;

      Ada.Environment_Variables.Set (Library_Variable, Library_Setting);
      declare
         Arguments : Argument_List :=
           (new String'(Script),
            new String'(Text_Numbers.Image (Long_Long_Integer (Descriptor))));
      begin
         Process := Non_Blocking_Spawn (Python, Arguments);
         for Argument of Arguments loop
            Free (Argument);
         end loop;
      end;
      if Process = Invalid_Pid then
         Refuse ("cannot run " & Python);
      end if;
   end Spawn;

end Host.Plant_Program;
