--  SPDX-License-Identifier: Apache-2.0

--  The contents of a row of the record besides time, overruns and clock.

with Partitions.Rows; use Partitions.Rows;

--  A signature: who instantiates with it references its formals.
pragma Warnings (Off, "*is not referenced");

generic
   --  Appends the node's columns to a row.
   with procedure Append_Values (To : in out Row);

   --  Appends the last columns.
   with procedure Append_Last (To : in out Row);

   --  Takes the row when it is complete.
   with procedure Publish (Item : Row) is null;

   --  The names of these columns, each after a comma.
   with function Column_Names return String;
   with function Last_Names return String;

   --  Rows have an aircraft's truth.
   with function Has_Truth return Boolean;
package Partitions.Row_Contents is

end Partitions.Row_Contents;
