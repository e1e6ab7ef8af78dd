--  SPDX-License-Identifier: Apache-2.0

with Host.Names;
with URVOS;

package body Partitions.Reports is

   use type Number;
   use type URVOS.Count;

   --  Goes to the next line and writes the field's name.
   procedure Begin_Field
     (This : in out Report; To : in out Writer; Name : String);

   procedure Put_Decimal
     (To : in out Writer; Value : Number; Decimals : Natural);

   procedure Begin_Field
     (This : in out Report; To : in out Writer; Name : String) is
   begin
      if This.Any then
         Put (To, ',');
      end if;
      New_Line (To);
      for Level in 1 .. This.Depth loop
         Put (To, "  ");
      end loop;
      Put (To, '"' & Name & """: ");
      This.Any := True;
   end Begin_Field;

   procedure Put_Decimal
     (To : in out Writer; Value : Number; Decimals : Natural)
   is
      Unit : Number := 10 ** Decimals;
   begin
      Put (To, Value / Unit);
      if Value mod Unit /= 0 then
         Put (To, '.');
         for Place in 1 .. Decimals loop
            Unit := Unit / 10;
            Put (To, Value / Unit mod 10);
         end loop;
      end if;
   end Put_Decimal;

   procedure Begin_Report (This : in out Report; To : in out Writer) is
   begin
      Put (To, '{');
      This.Depth := 1;
      This.Any   := False;
   end Begin_Report;

   procedure End_Report (This : in out Report; To : in out Writer) is
   begin
      New_Line (To);
      Put (To, '}');
      New_Line (To);
      This.Any := False;
   end End_Report;

   procedure Begin_Group
     (This : in out Report; To : in out Writer; Name : String) is
   begin
      Begin_Field (This, To, Name);
      Put (To, '{');
      This.Depth := This.Depth + 1;
      This.Any   := False;
   end Begin_Group;

   procedure End_Group (This : in out Report; To : in out Writer) is
   begin
      This.Depth := This.Depth - 1;
      if This.Any then
         New_Line (To);
         for Level in 1 .. This.Depth loop
            Put (To, "  ");
         end loop;
      end if;
      Put (To, '}');
      This.Any := True;
   end End_Group;

   procedure Put_Field
     (This  : in out Report;
      To    : in out Writer;
      Name  : String;
      Value : Number) is
   begin
      Begin_Field (This, To, Name);
      Put (To, Value);
   end Put_Field;

   procedure Put_Field
     (This  : in out Report;
      To    : in out Writer;
      Name  : String;
      Value : String) is
   begin
      Begin_Field (This, To, Name);
      Put (To, '"' & Value & '"');
   end Put_Field;

   procedure Add_Name (To : in out Unbounded_String; Name : String) is
   begin
      Append (To, (if To = "" then "" else ", ") & '"' & Name & '"');
   end Add_Name;

   procedure Put_Names
     (This  : in out Report;
      To    : in out Writer;
      Name  : String;
      Names : Unbounded_String) is
   begin
      if Names /= "" then
         Begin_Field (This, To, Name);
         Put (To, '[' & To_String (Names) & ']');
      end if;
   end Put_Names;

   procedure Put_Field
     (This     : in out Report;
      To       : in out Writer;
      Name     : String;
      Value    : Number;
      Decimals : Positive) is
   begin
      Begin_Field (This, To, Name);
      Put_Decimal (To, Value, Decimals);
   end Put_Field;

   procedure Put_Times
     (This  : in out Report;
      To    : in out Writer;
      Name  : String;
      Value : Statistics)
   is
      procedure Put_Part (Title : String; Part : Measure);

      procedure Put_Part (Title : String; Part : Measure) is
      begin
         Put (To, '"' & Title & """: ");
         Put_Decimal (To, Number (Part), Decimals => 1);
         Put (To, ", ");
      end Put_Part;
   begin
      Begin_Field (This, To, Name);
      Put (To, '{');
      Put_Part ("min", Value.Minimum);
      Put_Part ("median", Value.Median);
      Put_Part ("p99", Value.P99);
      Put_Part ("max", Value.Maximum);
      Put (To, """measured"": ");
      Put (To, Number (Value.Number));
      Put (To, '}');
   end Put_Times;

   procedure Put_Log
     (To   : in out Writer;
      This : in out Report;
      Log  : URV.Errors.Error_Log)
   is
      use URV.Errors;
      Item : Logs.History;
   begin
      Begin_Group (This, To, "events");
      for Kind in Error_Kind loop
         Item := Logs.History_Of (Log, Kind);
         if Item.Occurrences > 0 then
            Put_Field
              (This, To, Host.Names.Name (Kind), Number (Item.Occurrences));
         end if;
      end loop;
      End_Group (This, To);
   end Put_Log;

end Partitions.Reports;
