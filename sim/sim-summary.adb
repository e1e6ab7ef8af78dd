--  SPDX-License-Identifier: Apache-2.0

with Host.Names;       use Host.Names;
with Host.Text_Numbers;
with Host.Text_Output; use Host.Text_Output;

package body Sim.Summary is

   use type Text_Numbers.Number;

   --  Rounded to this number of decimals.
   function Rounded
     (Value : Long_Float; Decimals : Natural) return Long_Float
   is (Long_Float'Rounding (Value * 10.0 ** Decimals)
       / 10.0 ** Decimals);

   --  Microseconds in other units, exactly or nearly so.
   function In_Milliseconds (Time : Microseconds) return Long_Float is
     (Long_Float (Time) / 1.0E3);
   function In_Seconds (Time : Microseconds) return Long_Float is
     (Long_Float (Time) / 1.0E6);

   --  Simulated over real time; 0 when that passed too fast to measure.
   function Speed (Flight : Figures) return Long_Float is
     (if Flight.Elapsed > 0.0
      then In_Seconds (Flight.Flown) / Long_Float (Flight.Elapsed)
      else 0.0);

   --  A JSON object is written field by field: its first character, then
   --  fields, then its last. Names are plain and need no escapes.
   type Depth_Range is range 1 .. 3;
   type Object is record
      Depth : Depth_Range;
      Any   : Boolean := False;
   end record;

   Indent : constant String := "  ";

   Unknown_Value : constant String := "null";

   Usual_Remark  : constant String :=
     "  (at every start, until the first message)";

   procedure Begin_Field
     (To : in out Writer; Within : in out Object; Name : String);

   --  Closes the braces, and ends the line of the outermost.
   procedure End_Object (To : in out Writer; Ended : Object);

   --  A value without exponent and trailing zeros.
   procedure Put_Value (To : in out Writer; Value : Long_Float);

   procedure Put_Field
     (To     : in out Writer;
      Within : in out Object;
      Name   : String;
      Value  : Count);
   procedure Put_Field
     (To     : in out Writer;
      Within : in out Object;
      Name   : String;
      Value  : Long_Float);

   procedure Put_Link (To : in out Writer; Link : Link_Counts);
   procedure Put_Latency
     (To : in out Writer; Measured : Latency.Statistics);
   procedure Put_Lock (To : in out Writer; Flight : Figures);
   procedure Put_Events (To : in out Writer; Further : Result);
   procedure Put_Status
     (To : in out Writer; Further : Result; Where : Node);
   procedure Put_Known
     (To : in out Writer; Further : Result; Where : Node);

   --  Names, each in such marks.
   procedure Put_Names
     (To : in out Writer; Names : Name_Vectors.Vector; Mark : String);

   procedure Put_Quality (To : in out Writer; Further : Result);

   procedure Begin_Field
     (To : in out Writer; Within : in out Object; Name : String) is
   begin
      if Within.Any then
         Put (To, ',');
      end if;
      New_Line (To);
      for Level in 1 .. Within.Depth loop
         Put (To, Indent);
      end loop;
      Put (To, '"' & Name & """: ");
      Within.Any := True;
   end Begin_Field;

   procedure End_Object (To : in out Writer; Ended : Object) is
   begin
      if Ended.Any then
         New_Line (To);
         for Level in 2 .. Ended.Depth loop
            Put (To, Indent);
         end loop;
      end if;
      Put (To, '}');
   end End_Object;

   procedure Put_Value (To : in out Writer; Value : Long_Float) is
      use Text_Numbers;

      Unit  : Number := 10 ** Most_Decimals;
      Whole : constant Number := Number (abs Value * Long_Float (Unit));
      Rest  : Number := Whole mod Unit;
   begin
      if Value < 0.0 and then Whole > 0 then
         Put (To, '-');
      end if;
      Put (To, Whole / Unit);
      if Rest /= 0 then
         Put (To, '.');
         while Rest /= 0 loop
            Unit := Unit / 10;
            Put (To, Rest / Unit);
            Rest := Rest mod Unit;
         end loop;
      end if;
   end Put_Value;

   procedure Put_Field
     (To     : in out Writer;
      Within : in out Object;
      Name   : String;
      Value  : Count) is
   begin
      Begin_Field (To, Within, Name);
      Put (To, Text_Numbers.Number (Value));
   end Put_Field;

   procedure Put_Field
     (To     : in out Writer;
      Within : in out Object;
      Name   : String;
      Value  : Long_Float) is
   begin
      Begin_Field (To, Within, Name);
      Put_Value (To, Value);
   end Put_Field;

   procedure Add_Event
     (To        : in out Result;
      Kind      : String;
      How_Often : Count;
      Is_Usual  : Boolean) is
   begin
      To.Events.Append
        (Event'(Texts.To_Unbounded_String (Kind), How_Often, Is_Usual));
   end Add_Event;

   procedure Add_Status
     (To    : in out Result;
      Where : Node;
      Name  : String;
      Value : Word) is
   begin
      To.Statuses.Append
        (Status'(Where, Texts.To_Unbounded_String (Name), Value));
   end Add_Status;

   procedure Add_Known_Error
     (To        : in out Result;
      Where     : Node;
      Kind      : String;
      How_Often : Count) is
   begin
      To.Known.Append
        (Known_Error'(Where, Texts.To_Unbounded_String (Kind), How_Often));
   end Add_Known_Error;

   procedure Add_Failed_Surface (To : in out Result; Name : String) is
   begin
      To.Failed.Append (Texts.To_Unbounded_String (Name));
   end Add_Failed_Surface;

   procedure Add_Lost_Output (To : in out Result; Name : String) is
   begin
      To.Lost.Append (Texts.To_Unbounded_String (Name));
   end Add_Lost_Output;

   procedure Add_Quality
     (To    : in out Result;
      Name  : String;
      Value : Long_Float)
   is
      Largest : constant := 1.0E12;
   begin
      --  Written so that not-a-number fails the test.
      if abs Value <= Largest then
         To.Qualities.Append
           (Quality'(Name   => Texts.To_Unbounded_String (Name),
             Kind   => A_Number,
             Number => Rounded (Value, 3),
             Fact   => False));
      else
         Add_Unknown_Quality (To, Name);
      end if;
   end Add_Quality;

   procedure Add_Unknown_Quality (To : in out Result; Name : String) is
   begin
      To.Qualities.Append
        (Quality'(Name => Texts.To_Unbounded_String (Name), others => <>));
   end Add_Unknown_Quality;

   procedure Add_Quality
     (To    : in out Result;
      Name  : String;
      Value : Boolean) is
   begin
      To.Qualities.Append
        (Quality'(Name   => Texts.To_Unbounded_String (Name),
          Kind   => A_Fact,
          Number => 0.0,
          Fact   => Value));
   end Add_Quality;

   procedure Name_Quality (To : in out Result; Part : String) is
   begin
      To.Part := Texts.To_Unbounded_String (Part);
   end Name_Quality;

   procedure Put_Link (To : in out Writer; Link : Link_Counts) is
      Made : Object := (Depth => 2, others => <>);
   begin
      Put (To, '{');
      for Item in Link_Item loop
         Put_Field (To, Made, Name (Item), Link (Item));
      end loop;
      End_Object (To, Made);
   end Put_Link;

   procedure Put_Latency
     (To : in out Writer; Measured : Latency.Statistics)
   is
      Made : Object := (Depth => 2, others => <>);

      --  The names stay when there is no value.
      procedure Put_Time (Name : String; Time : Microseconds);

      procedure Put_Time (Name : String; Time : Microseconds) is
      begin
         Begin_Field (To, Made, Name);
         if Measured.Measured > 0 then
            Put_Value (To, In_Milliseconds (Time));
         else
            Put (To, Unknown_Value);
         end if;
      end Put_Time;
   begin
      Put (To, '{');
      Put_Time ("min", Measured.Minimum);
      Put_Time ("median", Measured.Median);
      Put_Time ("p99", Measured.P99);
      Put_Time ("max", Measured.Maximum);
      Put_Field (To, Made, "measured", Measured.Measured);
      Put_Field (To, Made, "overtaken", Measured.Overtaken);
      Put_Field (To, Made, "expired", Measured.Expired);
      End_Object (To, Made);
   end Put_Latency;

   procedure Put_Lock (To : in out Writer; Flight : Figures) is
      Made : Object := (Depth => 2, others => <>);
   begin
      Put (To, '{');
      Begin_Field (To, Made, "in_step_since_s");
      if Flight.Lock.Is_In_Step then
         Put_Value (To, In_Seconds (Flight.In_Step_Since));
      else
         Put (To, Unknown_Value);
      end if;
      Put_Field (To, Made, "frames_of_9_ticks", Flight.Lock.Shortened);
      Put_Field (To, Made, "frames_of_11_ticks", Flight.Lock.Lengthened);
      End_Object (To, Made);
   end Put_Lock;

   procedure Put_Events (To : in out Writer; Further : Result) is
      Made : Object := (Depth => 2, others => <>);
   begin
      Put (To, '{');
      for Each of Further.Events loop
         Put_Field (To, Made, Texts.To_String (Each.Kind), Each.How_Often);
      end loop;
      End_Object (To, Made);
   end Put_Events;

   procedure Put_Status
     (To : in out Writer; Further : Result; Where : Node)
   is
      Made : Object := (Depth => 3, others => <>);
   begin
      Put (To, '{');
      for Each of Further.Statuses loop
         if Each.Where = Where then
            Put_Field
              (To, Made, Texts.To_String (Each.Name), Count (Each.Value));
         end if;
      end loop;
      End_Object (To, Made);
   end Put_Status;

   procedure Put_Known
     (To : in out Writer; Further : Result; Where : Node)
   is
      Made : Object := (Depth => 3, others => <>);
   begin
      Put (To, '{');
      for Each of Further.Known loop
         if Each.Where = Where then
            Put_Field (To, Made, Texts.To_String (Each.Kind), Each.How_Often);
         end if;
      end loop;
      End_Object (To, Made);
   end Put_Known;

   procedure Put_Names
     (To : in out Writer; Names : Name_Vectors.Vector; Mark : String)
   is
      Any : Boolean := False;
   begin
      for Each of Names loop
         Put (To, (if Any then ", " else "") & Mark
              & Texts.To_String (Each) & Mark);
         Any := True;
      end loop;
   end Put_Names;

   procedure Put_Quality (To : in out Writer; Further : Result) is
      Made : Object := (Depth => 2, others => <>);
   begin
      Put (To, '{');
      for Each of Further.Qualities loop
         Begin_Field (To, Made, Texts.To_String (Each.Name));
         case Each.Kind is
            when A_Number => Put_Value (To, Each.Number);
            when A_Fact   =>
               Put (To, (if Each.Fact then "true" else "false"));
            when Unknown  => Put (To, Unknown_Value);
         end case;
      end loop;
      End_Object (To, Made);
   end Put_Quality;

   procedure Write
     (To      : in out Text_Output.Writer;
      Flight  : Figures;
      Further : Result)
   is
      Made   : Object := (Depth => 1, others => <>);
      Status : Object := (Depth => 2, others => <>);
      Known  : Object := (Depth => 2, others => <>);
   begin
      Put (To, '{');
      if Flight.Is_Unfinished then
         Begin_Field (To, Made, "unfinished");
         Put (To, "true");
      end if;
      Put_Field (To, Made, "seconds", In_Seconds (Flight.Flown));
      Put_Field (To, Made, "frames", Flight.Frames);
      Put_Field (To, Made, "speed", Rounded (Speed (Flight), 1));
      Begin_Field (To, Made, "link");
      Put_Link (To, Flight.Link);
      Put_Field (To, Made, "overruns", Flight.Overruns);
      if Flight.Has_Lock then
         Begin_Field (To, Made, "lock");
         Put_Lock (To, Flight);
      end if;
      Begin_Field (To, Made, "latency_ms");
      Put_Latency (To, Flight.Latency);
      Begin_Field (To, Made, "events");
      Put_Events (To, Further);

      Begin_Field (To, Made, "core_status");
      Put (To, '{');
      for Where in Node loop
         Begin_Field (To, Status, Name (Where));
         Put_Status (To, Further, Where);
      end loop;
      End_Object (To, Status);

      Begin_Field (To, Made, "ground_logs");
      Put (To, '{');
      for Where in Node loop
         Begin_Field (To, Known, Name (Where));
         Put_Known (To, Further, Where);
      end loop;
      End_Object (To, Known);

      if not Further.Failed.Is_Empty then
         Begin_Field (To, Made, "failed_surfaces");
         Put (To, '[');
         Put_Names (To, Further.Failed, Mark => [1 => '"']);
         Put (To, ']');
      end if;

      if not Further.Lost.Is_Empty then
         Begin_Field (To, Made, "lost_outputs");
         Put (To, '[');
         Put_Names (To, Further.Lost, Mark => [1 => '"']);
         Put (To, ']');
      end if;

      if not Further.Qualities.Is_Empty then
         Begin_Field (To, Made, Texts.To_String (Further.Part));
         Put_Quality (To, Further);
      end if;
      End_Object (To, Made);
      New_Line (To);
   end Write;

   procedure Print
     (To      : in out Text_Output.Writer;
      Flight  : Figures;
      Further : Result)
   is
      Link    : Link_Counts renames Flight.Link;
      Latency : Sim.Latency.Statistics renames Flight.Latency;

      procedure Put_Line (Line : String);

      --  With this number of decimals.
      procedure Put (Value : Long_Float; Decimals : Positive);

      procedure Put_Path
        (Title                         : String;
         Sent, Received, Bad, Scrapped : Link_Item);

      procedure Put_Line (Line : String) is
      begin
         Put_Line (To, Line);
      end Put_Line;

      procedure Put (Value : Long_Float; Decimals : Positive) is
      begin
         Put (To, Value, Decimals);
      end Put;

      function Image (Value : Count) return String is
        (Text_Numbers.Image (Long_Long_Integer (Value)));

      procedure Put_Path
        (Title                         : String;
         Sent, Received, Bad, Scrapped : Link_Item) is
      begin
         Put_Line
           (Title & Image (Link (Sent)) & " sent, "
            & Image (Link (Received)) & " received, "
            & Image (Link (Bad)) & " bad, "
            & Image (Link (Scrapped)) & " scrapped");
      end Put_Path;

   begin
      Put (To, "flown     ");
      Put (In_Seconds (Flight.Flown), 2);
      Put (To, " s, " & Image (Flight.Frames) & " frames, at ");
      Put (Speed (Flight), 1);
      Put_Line (" times real time");
      Put_Path
        ("uplink    ", Uplink_Sent, Uplink_Received,
         Uplink_Bad, Uplink_Scrapped);
      Put_Path
        ("downlink  ", Downlink_Sent, Downlink_Received,
         Downlink_Bad, Downlink_Scrapped);
      Put_Line
        ("resets    " & Image (Link (GSC_Resets)) & " of the ground's link, "
         & Image (Link (MCS_Resets)) & " of the aircraft's");
      Put_Line ("overruns  " & Image (Flight.Overruns));
      if Flight.Has_Lock then
         Put (To, "in step   ");
         if Flight.Lock.Is_In_Step then
            Put (To, "since ");
            Put (In_Seconds (Flight.In_Step_Since), 2);
            Put (To, " s, ");
         else
            Put (To, "no, ");
         end if;
         Put_Line
           (Image (Flight.Lock.Shortened) & " frames of 9 ticks, "
            & Image (Flight.Lock.Lengthened) & " of 11");
      end if;

      if Latency.Measured = 0 then
         Put_Line ("latency   not measured, no change reached the aircraft");
      else
         Put (To, "latency   ");
         Put (In_Milliseconds (Latency.Minimum), 3);
         Put (To, " ms at least, ");
         Put (In_Milliseconds (Latency.Median), 3);
         Put (To, " median, ");
         Put (In_Milliseconds (Latency.P99), 3);
         Put (To, " p99, ");
         Put (In_Milliseconds (Latency.Maximum), 3);
         Put_Line
           (" at most, of " & Image (Latency.Measured) & " changes");
      end if;

      if not Further.Events.Is_Empty then
         Put_Line ("events");
         for Each of Further.Events loop
            Put_Line
              ("  " & Texts.To_String (Each.Kind) & " "
               & Image (Each.How_Often)
               & (if Each.Is_Usual then Usual_Remark else ""));
         end loop;
      end if;

      if not Further.Failed.Is_Empty then
         Put (To, "failed    ");
         Put_Names (To, Further.Failed, Mark => "");
         Put_Line (", as reported to the ground");
      end if;

      if not Further.Lost.Is_Empty then
         Put (To, "lost      ");
         Put_Names (To, Further.Lost, Mark => "");
         Put_Line (": could not be written");
      end if;

      if not Further.Qualities.Is_Empty then
         Put_Line ("quality of the flight");
         for Each of Further.Qualities loop
            Put (To, "  " & Texts.To_String (Each.Name) & " ");
            case Each.Kind is
               when A_Number =>
                  Put (Each.Number, 3);
                  New_Line (To);
               when A_Fact   =>
                  Put_Line (if Each.Fact then "yes" else "no");
               when Unknown  =>
                  Put_Line ("unknown");
            end case;
         end loop;
      end if;
   end Print;

end Sim.Summary;
