--  The serial link between the two DUARTs, with the faults of a script:
--  what arrives of each character that is sent.
--
--  Several faults at once act together: masks are combined, and a lost
--  character stays lost. Where nothing is due, a character costs a few
--  comparisons however long the script is.

with Sim.Faults;

private with Ada.Containers.Ordered_Maps;
private with Ada.Containers.Vectors;

package Sim.Faulty_Line is

   --  Start, eight data, parity and two stop bits at 125 kbaud (D-4).
   Character_Time : constant Microseconds := 96;

   --  What the receiver's DUART makes of a character.
   type Arrival is record
      Data         : Byte;
      Parity_Error : Boolean;
   end record;

   --  None when the character is lost. More than one when faults insert
   --  or repeat characters; none of them does so yet.
   Most_Arrivals : constant := 4;
   type Arrival_Count is range 0 .. Most_Arrivals;
   type Arrival_List is
     array (Arrival_Count range 1 .. Most_Arrivals) of Arrival;

   type Line is limited private;

   --  Takes the script over. A line without a script has no faults.
   procedure Prepare (Made : in out Line; Script : Faults.Script);

   --  Sends one character. Time is when its start bit begins, and must not
   --  decrease within a direction. Every character that a DUART sends is
   --  told, for they are counted.
   procedure Transmit
     (Over     : in out Line;
      Way      : Direction;
      Time     : Microseconds;
      Data     : Byte;
      Count    : out Arrival_Count;
      Arriving : out Arrival_List);

private

   --  How many characters a direction has carried.
   type Character_Number is range 0 .. 2 ** 62;

   --  What happens to one character.
   type Effect is record
      Mask    : Faults.Character_Bits := 0;
      Is_Lost : Boolean := False;
   end record;

   package Effect_Maps is new Ada.Containers.Ordered_Maps
     (Character_Number, Effect);

   package Fault_Vectors is new Ada.Containers.Vectors
     (Positive, Faults.Fault, Faults."=");

   --  The line is silent from First until just before Stop.
   type Silence is record
      First : Microseconds;
      Stop  : Microseconds;
   end record;

   package Silence_Vectors is new Ada.Containers.Vectors
     (Positive, Silence);

   Never : constant Microseconds := Microseconds'Last;

   type One_Way is record
      Sent : Character_Number := 0;

      --  Faults of single characters by time. From Next on they wait for
      --  their time, which is Next_Time; those before have become due and
      --  are found under the number of the character they are for.
      Waiting   : Fault_Vectors.Vector;
      Next      : Positive := 1;
      Next_Time : Microseconds := Never;
      Due       : Effect_Maps.Map;
      Next_Due  : Character_Number := Character_Number'Last;

      --  The first silence that does not lie in the past.
      Silence_Index : Positive := 1;
      Next_Silence  : Silence  := (Never, Never);
   end record;

   type Both_Ways is array (Direction) of One_Way;

   type Line is limited record
      Ways : Both_Ways;

      --  In order and apart from each other.
      Silences : Silence_Vectors.Vector;
   end record;

end Sim.Faulty_Line;
