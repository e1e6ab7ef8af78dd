--  SPDX-License-Identifier: Apache-2.0

with Ada.Command_Line;
with Ada.Directories;
with GNAT.OS_Lib; use GNAT.OS_Lib;

package body Partitions.Notes is

   procedure Print (What : String) is
      Line    : constant String :=
        Ada.Directories.Simple_Name (Ada.Command_Line.Command_Name) & ": "
        & What & ASCII.LF;
      Written : Integer;
   begin
      Written := Write (Standerr, Line'Address, Line'Length);

      --  Nobody reads it: that is no reason to stop.
      pragma Unreferenced (Written);
   end Print;

end Partitions.Notes;
