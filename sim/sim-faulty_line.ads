--  SPDX-License-Identifier: Apache-2.0

--  The serial link between the two DUARTs, with the faults of a script: the
--  arrivals for each sent character (SIM-2).
--
--  Several simultaneous faults are combined: masks are combined, and a lost
--  character stays lost, together with its additions. If no fault is due, a
--  character costs a few comparisons, whatever the length of the script.
--
--  A character that the line adds takes a character time like any other:
--
--    an inserted one is heard as the start bit of the one after it begins,
--    a doubled one is heard again a character time after the first;
--
--  The receiver therefore hears it after the character before it and before
--  the following one, and may begin to answer in between. The sender is not
--  delayed. Random bit errors hit sent characters: both copies of a doubled
--  one have the same errors, and an inserted one has none.

with Sim.Faults;
with Sim.Noise;
with Sim.Replays;
with URVOS; use URVOS;

private with Ada.Containers.Ordered_Maps;
private with Ada.Containers.Vectors;
private with Sim.Windows;

package Sim.Faulty_Line is

   --  The receiving DUART's result for a character.
   type Arrival is record
      Data         : Byte;
      Parity_Error : Boolean;
   end record;

   --  In the order of arrival. There is room for eight; further characters
   --  that faults add are not received.
   Most_Arrivals : constant := 8;
   type Arrival_Count is range 0 .. Most_Arrivals;
   type Arrival_Array is
     array (Arrival_Count range 1 .. Most_Arrivals) of Arrival;
   type Arrival_List is record
      Length : Arrival_Count := 0;
      Items  : Arrival_Array;
   end record;

   procedure Append (To : in out Arrival_List; Added : Arrival);
   procedure Append (To : in out Arrival_List; Added : Arrival_List);

   --  The arrivals caused by one sent character: when its start bit begins,
   --  when its last stop bit ends, and a character time later.
   type Delivery is record
      Before  : Arrival_List;
      Is_Lost : Boolean;
      Itself  : Arrival;
      After   : Arrival_List;
   end record;

   type Line is limited private;

   --  Takes over the script. A line without a script has no faults.
   procedure Prepare
     (Made   : in out Line;
      Script : Faults.Script;
      Seed   : Seed_Number);

   --  Sends one character. Time is when its start bit begins, and must not
   --  decrease within a direction. Every character that a DUART sends must be
   --  passed, because they are counted.
   procedure Transmit
     (Over     : in out Line;
      Path     : Direction;
      Time     : Microseconds;
      Data     : Byte;
      Heard    : out Delivery)
   with Inline;

   --  The number of characters that a fault waits for: after its time fewer
   --  were sent.
   function Awaited (From : Line) return Natural;

private

   --  The number of characters that a direction has carried.
   type Character_Number is range 0 .. 2 ** 62;

   --  The combined effect of faults on one character.
   type Effect is record
      Mask     : Faults.Character_Bits := 0;
      Is_Lost  : Boolean := False;
      Inserted : Arrival_List;
      Copies   : Arrival_Count := 0;
   end record;

   package Effect_Maps is new Ada.Containers.Ordered_Maps
     (Character_Number, Effect);

   --  Bit errors until Stop.
   type Noise_Spell is record
      Stop  : Microseconds;
      Level : Noise.Level;
   end record;

   package Noise_Vectors is new Ada.Containers.Vectors
     (Positive, Noise_Spell);

   type One_Path is record
      Sent : Character_Number := 0;

      --  Faults of single characters by time. From Next on they wait for their
      --  time, which is Next_Time; earlier ones are due and are found under
      --  the number of their character.
      Waiting   : Faults.Fault_List;
      Next      : Positive := 1;
      Next_Time : Microseconds := Never;
      Due       : Effect_Maps.Map;
      Next_Due  : Character_Number := Character_Number'Last;

      --  Periods of bit errors: future ones, and those that may be active.
      --  Next_Noise is the next time to look at them.
      Noises        : Faults.Fault_List;
      Noise_Index   : Positive := 1;
      Active_Noises : Noise_Vectors.Vector;
      Next_Noise    : Microseconds := Never;
      Chance        : Noise.Source;

      Silences : Windows.List;
   end record;

   type Two_Middles is array (Direction) of Replays.Middle;

   type Both_Paths is array (Direction) of One_Path;

   type Line is limited record
      Paths   : Both_Paths;
      Middles : Two_Middles;
   end record;

   function Awaited (From : Line) return Natural is
     (Natural (From.Paths (Up).Due.Length)
      + Natural (From.Paths (Down).Due.Length));

end Sim.Faulty_Line;
