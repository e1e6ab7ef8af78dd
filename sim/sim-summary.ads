--  SPDX-License-Identifier: Apache-2.0

--  The result of a flight: a JSON object for scripts (--summary) and a few
--  lines for people.
--
--  Two runs of one flight give the same summary except for "speed", which is
--  measured in real time.

with Host.Text_Output;
with Sim.Latency;
with URVOS; use URVOS;
with URVOS.Frame_Locks;

private with Ada.Containers.Vectors;
private with Ada.Strings.Unbounded;

package Sim.Summary is

   --  The values of every flight.
   type Figures is record
      Flown    : Microseconds;
      Frames   : Count;
      Elapsed  : Duration;
      Link     : Link_Counts;
      Overruns : Count;
      Latency  : Sim.Latency.Statistics;

      --  For a flight with frames in step (FRM-6).
      Has_Lock : Boolean := False;
      Lock     : URVOS.Frame_Locks.Lock_State;
      In_Step_Since : Microseconds := 0;

      --  The flight continues: these are its values so far.
      Is_Unfinished : Boolean := False;
   end record;

   type Result is limited private;

   --  Adds an event of the flight, by kind. Kinds appear in the order in which
   --  they were added. The printed text marks the events that every start
   --  causes.
   procedure Add_Event
     (To        : in out Result;
      Kind      : String;
      How_Often : Count;
      Is_Usual  : Boolean);

   --  A word of CORE's status at the end of the flight. The words of a node
   --  are added one after the other.
   procedure Add_Status
     (To    : in out Result;
      Where : Node;
      Name  : String;
      Value : Word);

   --  The errors of one kind in a node's error log, as the ground's CORE knows
   --  them at the end of the flight (SAF-7).
   procedure Add_Known_Error
     (To        : in out Result;
      Where     : Node;
      Kind      : String;
      How_Often : Count);

   --  A failed surface, as reported to the ground (EXT-6). The result has this
   --  list only if there is one.
   procedure Add_Failed_Surface (To : in out Result; Name : String);

   --  An output that could not be written (SIM-8), in the same way.
   procedure Add_Lost_Output (To : in out Result; Name : String);

   --  The quality of the pilot's flight. A name ends with its unit, as in
   --  "altitude_rms_ft". Values have three decimals; not-a-number is given as
   --  null.
   procedure Add_Quality
     (To    : in out Result;
      Name  : String;
      Value : Long_Float);
   procedure Add_Quality
     (To    : in out Result;
      Name  : String;
      Value : Boolean);

   --  A value that could not be measured: null.
   procedure Add_Unknown_Quality (To : in out Result; Name : String);

   --  The name of that part in the JSON object, by default "flight_quality".
   procedure Name_Quality (To : in out Result; Part : String);

   --  Writes the JSON object.
   procedure Write
     (To      : in out Text_Output.Writer;
      Flight  : Figures;
      Further : Result)
     with Pre => Text_Output.Is_Open (To);

   --  Prints the short text.
   procedure Print
     (To      : in out Text_Output.Writer;
      Flight  : Figures;
      Further : Result)
     with Pre => Text_Output.Is_Open (To);

private

   package Texts renames Ada.Strings.Unbounded;

   type Event is record
      Kind      : Texts.Unbounded_String;
      How_Often : Count;
      Is_Usual  : Boolean;
   end record;

   package Event_Vectors is new Ada.Containers.Vectors (Positive, Event);

   type Status is record
      Where : Node;
      Name  : Texts.Unbounded_String;
      Value : Word;
   end record;

   package Status_Vectors is new Ada.Containers.Vectors (Positive, Status);

   type Known_Error is record
      Where     : Node;
      Kind      : Texts.Unbounded_String;
      How_Often : Count;
   end record;

   package Known_Error_Vectors is new Ada.Containers.Vectors
     (Positive, Known_Error);

   package Name_Vectors is new Ada.Containers.Vectors
     (Positive, Texts.Unbounded_String, Texts."=");

   type Value_Kind is (A_Number, A_Fact, Unknown);

   type Quality is record
      Name   : Texts.Unbounded_String;
      Kind   : Value_Kind := Unknown;
      Number : Long_Float := 0.0;
      Fact   : Boolean    := False;
   end record;

   package Quality_Vectors is new Ada.Containers.Vectors
     (Positive, Quality);

   type Result is limited record
      Events    : Event_Vectors.Vector;
      Statuses  : Status_Vectors.Vector;
      Known     : Known_Error_Vectors.Vector;
      Failed    : Name_Vectors.Vector;
      Lost      : Name_Vectors.Vector;
      Qualities : Quality_Vectors.Vector;
      Part      : Texts.Unbounded_String :=
        Texts.To_Unbounded_String ("flight_quality");
   end record;

end Sim.Summary;
