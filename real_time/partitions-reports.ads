--  SPDX-License-Identifier: Apache-2.0

--  The result of a run as a JSON object (--summary), and as a few lines for
--  people.

with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;

with Host.Text_Numbers;
with Host.Text_Output;        use Host.Text_Output;
with Partitions.Measurements; use Partitions.Measurements;
with URV.Errors;

package Partitions.Reports is

   subtype Number is Host.Text_Numbers.Number;

   --  A JSON object, field by field; Begin_Group opens a named object in it.
   type Report is limited private;

   procedure Begin_Report (This : in out Report; To : in out Writer);
   procedure End_Report (This : in out Report; To : in out Writer);

   procedure Begin_Group
     (This : in out Report; To : in out Writer; Name : String);
   procedure End_Group (This : in out Report; To : in out Writer);

   procedure Put_Field
     (This  : in out Report;
      To    : in out Writer;
      Name  : String;
      Value : Number);

   procedure Put_Field
     (This  : in out Report;
      To    : in out Writer;
      Name  : String;
      Value : String);

   --  Adds a name to an array of them, initially empty.
   procedure Add_Name (To : in out Unbounded_String; Name : String);

   --  Writes nothing when there is none.
   procedure Put_Names
     (This  : in out Report;
      To    : in out Writer;
      Name  : String;
      Names : Unbounded_String);

   --  A value with decimals, counted in units of the last of them.
   procedure Put_Field
     (This     : in out Report;
      To       : in out Writer;
      Name     : String;
      Value    : Number;
      Decimals : Positive);

   --  "min", "median", "p99", "max" in microseconds, and the count. The value
   --  is in tenths of them, as all times of Measurements.
   procedure Put_Times
     (This  : in out Report;
      To    : in out Writer;
      Name  : String;
      Value : Statistics);

   --  "events": the count of each kind of error that occurred.
   procedure Put_Log
     (To   : in out Writer;
      This : in out Report;
      Log  : URV.Errors.Error_Log);

private

   type Report is limited record
      Depth : Positive := 1;
      Any   : Boolean  := False;
   end record;

end Partitions.Reports;
