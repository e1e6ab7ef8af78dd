--  SPDX-License-Identifier: Apache-2.0

with Host.Names;
with Host.Text_Numbers; use Host.Text_Numbers;
with Host.Text_Output;  use Host.Text_Output;

package body Host.Event_Log is

   procedure Write
     (To   : in out Text_Output.Writer;
      Node : String;
      Log  : Error_Log)
   is
      procedure Put_Field (Name : String; Value : Number);

      procedure Put_Field (Name : String; Value : Number) is
      begin
         Put (To, ",""" & Name & """:");
         Put (To, Value);
      end Put_Field;

      function Frame (Now : Clock_Tick) return Number is
        (Number (Now / Ticks_Per_Major_Frame));

      function Milliseconds (Now : Clock_Tick) return Number is
        (Number (Time_Of (Now) / Microseconds_Per_Millisecond));

   begin
      for Kind in Error_Kind loop
         declare
            Item : constant Logs.History := Logs.History_Of (Log, Kind);
         begin
            if Item.Occurrences > 0 then
               Put
                 (To,
                  "{""node"":""" & Node & """,""kind"":"""
                  & Names.Name (Kind) & '"');
               Put_Field ("count", Number (Item.Occurrences));
               Put_Field ("first_frame", Frame (Item.First));
               Put_Field ("last_frame", Frame (Item.Last));
               Put_Field ("first_ms", Milliseconds (Item.First));
               Put_Field ("last_ms", Milliseconds (Item.Last));
               Put_Field ("last_detail", Number (Item.Last_Detail));
               Put (To, '}');
               New_Line (To);
            end if;
         end;
      end loop;
   end Write;

end Host.Event_Log;
