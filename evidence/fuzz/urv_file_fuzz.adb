--  SPDX-License-Identifier: Apache-2.0

--  Gives the readers of key, fault, conditions, orders, sticks and sensors
--  files what comes on standard input (SEC-14). Every contract is executed. A
--  refusal is the right answer to a bad file; any other exception aborts.
--
--  The first byte chooses the kind of file: K, F, C, O, S or N.

with Ada.Exceptions;
with Ada.Text_IO;
with GNAT.OS_Lib;       use GNAT.OS_Lib;
with Interfaces.C;

with Host;
with Host.Ground_Orders;
with Host.Key_Files;
with Host.Sensor_Scripts;
with Host.Stick_Scripts;
with Sim.Conditions;
with Sim.Faults;

procedure URV_File_Fuzz is

   use type Interfaces.C.int;

   Room : constant := 65_536;

   function Next_Input
     (Input : out String; Size : Interfaces.C.int) return Interfaces.C.int
   with Import, Convention => C, External_Name => "urv_next_input";

   procedure Crash
   with Import, Convention => C, External_Name => "urv_crash", No_Return;

   function Truncate
     (File : File_Descriptor; Length : Long_Long_Integer)
      return Interfaces.C.int
   with Import, Convention => C, External_Name => "ftruncate64";

   procedure Load (Kind : Character; Name : String);

   procedure Load (Kind : Character; Name : String) is
   begin
      case Kind is
         when 'K' =>
            declare
               Keys : Host.Key_Files.Key_Ring;
            begin
               Host.Key_Files.Load (Keys, Name);
            end;
         when 'F' =>
            declare
               Loaded : Sim.Faults.Script;
            begin
               Sim.Faults.Load (Loaded, Name);
            end;
         when 'C' =>
            declare
               Loaded : Sim.Conditions.Script;
            begin
               Sim.Conditions.Load (Loaded, Name, Has_Aircraft => True);
            end;
         when 'O' =>
            declare
               Loaded : Host.Ground_Orders.Script;
            begin
               Host.Ground_Orders.Load (Loaded, Name);
            end;
         when 'S' =>
            declare
               Loaded : Host.Stick_Scripts.Script;
            begin
               Host.Stick_Scripts.Load (Loaded, Name);
            end;
         when 'N' =>
            declare
               Loaded : Host.Sensor_Scripts.Script;
            begin
               Host.Sensor_Scripts.Load (Loaded, Name);
            end;
         when others => null;
      end case;
   exception
      when Host.Bad_Input => null;
   end Load;

   Input  : String (1 .. Room);
   Length : Interfaces.C.int;
   File   : File_Descriptor;
   Name   : String_Access;
   Unused : Interfaces.C.int;
   Done   : Boolean;
begin
   Create_Temp_File (File, Name);
   loop
      Length := Next_Input (Input, Room);
      exit when Length < 0;
      if Length > 0 then
         Unused := Truncate (File, 0);
         Lseek (File, 0, Seek_Set);
         if Write (File, Input (2)'Address, Integer (Length) - 1)
           = Integer (Length) - 1
         then
            Load (Input (1), Name.all);
         end if;
      end if;
   end loop;
   Close (File);
   Delete_File (Name.all, Done);
exception
   when Found : others =>
      Ada.Text_IO.Put_Line
        (Ada.Text_IO.Standard_Error,
         Ada.Exceptions.Exception_Information (Found));
      Crash;
end URV_File_Fuzz;
