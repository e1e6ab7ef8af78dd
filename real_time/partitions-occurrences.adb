--  SPDX-License-Identifier: Apache-2.0

with Host.Names;
with Host.Text_Numbers; use Host.Text_Numbers;
with Host.Text_Output;  use Host.Text_Output;

package body Partitions.Occurrences is

   Is_Finished : Boolean := False with Atomic;

   protected body Occurrence is

      procedure Add (At_Time : Microseconds) is
      begin
         if Is_Finished then
            return;
         end if;
         if Counted.Number = 0 then
            Counted.First := At_Time;
         end if;
         Counted.Last := At_Time;
         Counted.Number := Incremented (Counted.Number);
      end Add;

      function Contents return History is (Counted);

   end Occurrence;

   procedure Finish is
   begin
      Is_Finished := True;
   end Finish;

   procedure Write
     (To    : in out Host.Text_Output.Writer;
      Where : Node;
      Kind  : String;
      This  : History)
   is
      procedure Put_Field (Name : String; Value : Long_Long_Integer);

      procedure Put_Field (Name : String; Value : Long_Long_Integer) is
      begin
         Put (To, ",""" & Name & """:" & Image (Value));
      end Put_Field;

      function Milliseconds (Time : Microseconds) return Long_Long_Integer is
        (Long_Long_Integer (Time / Microseconds_Per_Millisecond));

      function Frame (Time : Microseconds) return Long_Long_Integer is
        (Long_Long_Integer (Time / Major_Frame));
   begin
      if This.Number > 0 then
         Put
           (To,
            "{""node"":""" & Host.Names.Name (Where) & """,""kind"":"""
            & Kind & '"');
         Put_Field ("count", Long_Long_Integer (This.Number));
         Put_Field ("first_frame", Frame (This.First));
         Put_Field ("last_frame", Frame (This.Last));
         Put_Field ("first_ms", Milliseconds (This.First));
         Put_Field ("last_ms", Milliseconds (This.Last));
         Put_Field ("last_detail", 0);
         Put (To, '}');
         New_Line (To);
      end if;
   end Write;

end Partitions.Occurrences;
