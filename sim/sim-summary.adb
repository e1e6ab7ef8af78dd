with Ada.Long_Float_Text_IO;
with Ada.Strings.Fixed;
with Ada.Text_IO;

with GNATCOLL.JSON; use GNATCOLL.JSON;

with Sim.Names; use Sim.Names;

package body Sim.Summary is

   procedure Put_Line (Line : String) renames Ada.Text_IO.Put_Line;

   --  Rounded to so many decimals.
   function Rounded
     (Value : Long_Float; Decimals : Natural) return Long_Float
   is (Long_Float'Rounding (Value * 10.0 ** Decimals)
       / 10.0 ** Decimals);

   --  As decimal text, "12.5".
   function Image (Value : Long_Float; Decimals : Positive) return String;
   function Image (Value : Count) return String;

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

   --  A whole number without decimals, any other one with them.
   function To_JSON (Value : Long_Float) return JSON_Value;
   function To_JSON (Value : Count) return JSON_Value is
     (Create (Integer (Value)));

   function Link_Object (Link : Link_Counts) return JSON_Value;
   function Latency_Object
     (Measured : Latency.Statistics) return JSON_Value;
   function Event_Object (Further : Result) return JSON_Value;
   function Status_Object
     (Further : Result; Where : Node) return JSON_Value;
   function Quality_Object (Further : Result) return JSON_Value;

   function Image (Value : Long_Float; Decimals : Positive) return String is
      Text : String (1 .. 40);
   begin
      Ada.Long_Float_Text_IO.Put
        (Text, Rounded (Value, Decimals), Aft => Decimals, Exp => 0);
      return Ada.Strings.Fixed.Trim (Text, Ada.Strings.Left);
   end Image;

   function Image (Value : Count) return String is
     (Ada.Strings.Fixed.Trim (Value'Image, Ada.Strings.Left));

   function To_JSON (Value : Long_Float) return JSON_Value is
      Whole_Up_To : constant := 2.0 ** 52;
   begin
      if abs Value < Whole_Up_To
        and then Value = Long_Float'Rounding (Value)
      then
         return Create (Long_Long_Integer (Value));
      else
         return Create (Value);
      end if;
   end To_JSON;

   procedure Add_Event
     (To        : in out Result;
      Kind      : String;
      How_Often : Count) is
   begin
      To.Events.Append
        (Event'(Texts.To_Unbounded_String (Kind), How_Often));
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

   procedure Add_Quality
     (To    : in out Result;
      Name  : String;
      Value : Long_Float)
   is
      Largest : constant := 1.0E12;
   begin
      --  Written so that what is not a number is not inside either.
      if abs Value <= Largest then
         To.Qualities.Append
           (Quality'(Name   => Texts.To_Unbounded_String (Name),
             Kind   => A_Number,
             Number => Rounded (Value, 3),
             Fact   => False));
      else
         To.Qualities.Append
           (Quality'(Name => Texts.To_Unbounded_String (Name), others => <>));
      end if;
   end Add_Quality;

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

   function Link_Object (Link : Link_Counts) return JSON_Value is
      Made : constant JSON_Value := Create_Object;
   begin
      for Item in Link_Item loop
         Made.Set_Field (Name (Item), To_JSON (Link (Item)));
      end loop;
      return Made;
   end Link_Object;

   function Latency_Object
     (Measured : Latency.Statistics) return JSON_Value
   is
      Made : constant JSON_Value := Create_Object;

      --  The names stay when there is nothing to say.
      function Value (Time : Microseconds) return JSON_Value is
        (if Measured.Measured > 0
         then To_JSON (In_Milliseconds (Time))
         else JSON_Null);
   begin
      Made.Set_Field ("min", Value (Measured.Minimum));
      Made.Set_Field ("median", Value (Measured.Median));
      Made.Set_Field ("p99", Value (Measured.P99));
      Made.Set_Field ("max", Value (Measured.Maximum));
      Made.Set_Field ("measured", To_JSON (Measured.Measured));
      Made.Set_Field ("overtaken", To_JSON (Measured.Overtaken));
      Made.Set_Field ("expired", To_JSON (Measured.Expired));
      return Made;
   end Latency_Object;

   function Event_Object (Further : Result) return JSON_Value is
      Made : constant JSON_Value := Create_Object;
   begin
      for Each of Further.Events loop
         Made.Set_Field
           (Texts.To_String (Each.Kind), To_JSON (Each.How_Often));
      end loop;
      return Made;
   end Event_Object;

   function Status_Object
     (Further : Result; Where : Node) return JSON_Value
   is
      Made : constant JSON_Value := Create_Object;
   begin
      for Each of Further.Statuses loop
         if Each.Where = Where then
            Made.Set_Field
              (Texts.To_String (Each.Name), To_JSON (Count (Each.Value)));
         end if;
      end loop;
      return Made;
   end Status_Object;

   function Quality_Object (Further : Result) return JSON_Value is
      Made : constant JSON_Value := Create_Object;
   begin
      for Each of Further.Qualities loop
         Made.Set_Field
           (Texts.To_String (Each.Name),
            (case Each.Kind is
                when A_Number => To_JSON (Each.Number),
                when A_Fact   => Create (Each.Fact),
                when Unknown  => JSON_Null));
      end loop;
      return Made;
   end Quality_Object;

   procedure Write
     (To      : in out Text_Output.Writer;
      Flight  : Figures;
      Further : Result)
   is
      Made   : constant JSON_Value := Create_Object;
      Status : constant JSON_Value := Create_Object;
   begin
      for Where in Node loop
         Status.Set_Field (Name (Where), Status_Object (Further, Where));
      end loop;

      Made.Set_Field ("seconds", To_JSON (In_Seconds (Flight.Flown)));
      Made.Set_Field ("frames", To_JSON (Flight.Frames));
      Made.Set_Field ("speed", To_JSON (Rounded (Speed (Flight), 1)));
      Made.Set_Field ("link", Link_Object (Flight.Link));
      Made.Set_Field ("overruns", To_JSON (Flight.Overruns));
      Made.Set_Field ("latency_ms", Latency_Object (Flight.Latency));
      Made.Set_Field ("events", Event_Object (Further));
      Made.Set_Field ("core_status", Status);
      if not Further.Qualities.Is_Empty then
         Made.Set_Field ("flight_quality", Quality_Object (Further));
      end if;
      Text_Output.Put (To, Write (Made, Compact => False));
      Text_Output.New_Line (To);
   end Write;

   procedure Print (Flight : Figures; Further : Result) is
      Link    : Link_Counts renames Flight.Link;
      Latency : Sim.Latency.Statistics renames Flight.Latency;

      procedure Put_Way
        (Title                         : String;
         Sent, Received, Bad, Scrapped : Link_Item);

      procedure Put_Way
        (Title                         : String;
         Sent, Received, Bad, Scrapped : Link_Item) is
      begin
         Put_Line
           (Title & Image (Link (Sent)) & " sent, "
            & Image (Link (Received)) & " received, "
            & Image (Link (Bad)) & " bad, "
            & Image (Link (Scrapped)) & " scrapped");
      end Put_Way;

      function Shown (Time : Microseconds) return String is
        (Image (In_Milliseconds (Time), 3));
   begin
      Put_Line
        ("flown     " & Image (In_Seconds (Flight.Flown), 2) & " s, "
         & Image (Flight.Frames) & " frames, at "
         & Image (Speed (Flight), 1) & " times real time");
      Put_Way
        ("uplink    ", Uplink_Sent, Uplink_Received,
         Uplink_Bad, Uplink_Scrapped);
      Put_Way
        ("downlink  ", Downlink_Sent, Downlink_Received,
         Downlink_Bad, Downlink_Scrapped);
      Put_Line
        ("resets    " & Image (Link (GSC_Resets)) & " of the ground's link, "
         & Image (Link (MCS_Resets)) & " of the aircraft's");
      Put_Line ("overruns  " & Image (Flight.Overruns));

      if Latency.Measured = 0 then
         Put_Line ("latency   not measured, no change reached the aircraft");
      else
         Put_Line
           ("latency   " & Shown (Latency.Minimum) & " ms at least, "
            & Shown (Latency.Median) & " median, "
            & Shown (Latency.P99) & " p99, "
            & Shown (Latency.Maximum) & " at most, of "
            & Image (Latency.Measured) & " changes");
      end if;

      if not Further.Events.Is_Empty then
         Put_Line ("events");
         for Each of Further.Events loop
            Put_Line
              ("  " & Texts.To_String (Each.Kind) & " "
               & Image (Each.How_Often));
         end loop;
      end if;

      if not Further.Qualities.Is_Empty then
         Put_Line ("quality of the flight");
         for Each of Further.Qualities loop
            Put_Line
              ("  " & Texts.To_String (Each.Name) & " "
               & (case Each.Kind is
                     when A_Number => Image (Each.Number, 3),
                     when A_Fact   => (if Each.Fact then "yes" else "no"),
                     when Unknown  => "unknown"));
         end loop;
      end if;
   end Print;

end Sim.Summary;
