--  SPDX-License-Identifier: Apache-2.0

--  Test cards: the inputs of a flight test that the aircraft adds to its
--  servos' words, to the sticks, or to the laws' commands (FTI-1, FTI-2).
--  docs/flight-test.md describes their use.
--  URV.Card_Blocks has the block that carries one.

with URVOS;          use URVOS;
with URV.Frame_Times; use URV.Frame_Times;
with URV.Law_Inputs;
with URV.Signal_Tables; use URV.Signal_Tables;

package URV.Test_Cards with Pure, SPARK_Mode is

   subtype Field is Word range 0 .. 16#FFF#;

   --  Head: slot * 256 + grouping * 16 + kind.
   --  Surfaces: a bit for each input, see Test_Surface, and the place where it
   --  is added, see Input_Place.
   --  Amplitude: in words of a surface, a stick, or a command.
   --  Time: of a pulse, or of the whole sweep or multisine, in 0.01 s.
   --  First: the first frequency of a sweep, the base frequency of a
   --  multisine, in 0.01 Hz.
   --  Last: the last frequency of a linear sweep; the octaves of an
   --  exponential one, in 64ths; first harmonic * 16 + number of harmonics of
   --  each signal of a multisine.
   --  Attitude: largest bank + 64 * largest pitch, in degrees.
   --  Airflow: largest alpha in degrees + 64 * largest deviation of the load
   --  factor from 1, in tenths.
   --  Slowest, Fastest: airspeeds; Lowest: altitude; in their words.
   type Card_Item is
     (Head, Surfaces, Amplitude, Time, First, Last,
      Attitude, Airflow, Slowest, Fastest, Lowest);

   type Card is array (Card_Item) of Field;

   Empty_Card : constant Card := (others => 0);

   --  The first word of such a block is its kind. An Empty card clears its
   --  slot; Choose selects the slot of the next run.
   type Card_Kind is
     (Empty, Step, Doublet, Three_Two_One_One,
      Linear_Sweep, Exponential_Sweep, Multisine, Choose);

   subtype Pulses is Card_Kind range Step .. Three_Two_One_One;
   subtype Signal_Kind is Card_Kind range Step .. Multisine;

   type Slot_Or_None is range 0 .. 8;
   subtype Slot is Slot_Or_None range 1 .. 8;

   --  The surfaces that a card may move, in the order of the bits. The flaps
   --  have no test inputs.
   type Test_Surface is
     (Left_Aileron, Right_Aileron, Left_Elevator, Right_Elevator,
      Left_Rudder, Right_Rudder);

   --  A card adds its inputs to the servos, to the sticks, or to the laws'
   --  commands. The bits of the surfaces then mean: for the sticks, the left
   --  aileron is roll, the left elevator pitch, the left rudder yaw; for the
   --  commands, the left aileron is bank, the left elevator pitch, the left
   --  rudder altitude, the right rudder airspeed. No other bit is permitted.
   type Input_Place is (At_Servo, At_Stick, At_Command);

   Surface_Bits : constant Word := 2#11_1111#;
   Place_Bits   : constant Word := 16#FC0#;
   Stick_Place  : constant Word := 2 ** 6;
   Command_Place : constant Word := 2 ** 7;
   No_Stick     : constant Word := 2#10_1010#;
   No_Command   : constant Word := 2#00_1010#;

   --  Limits

   Most_Amplitude : constant := Law_Inputs.Most_Input;
   Most_Frequency : constant := 1_000;
   Least_Sweep    : constant := 10;
   Most_Base      : constant := 200;
   Most_Octaves   : constant := 448;
   Most_Signals   : constant := 4;

   --  A limit of an angle or load with this value is none; so are a Slowest
   --  and Lowest of 0, and a Fastest of 4095. Such a card does not need the
   --  sensor.
   No_Limit : constant := 63;

   subtype Limit is Integer range 0 .. 63;
   subtype Frame_Count is Integer range 0 .. 16_383;

   --  Parts of a card

   function Has_Kind (Source : Card) return Boolean is
     (Source (Head) mod 16 <= Card_Kind'Pos (Card_Kind'Last))
   with Global => null;

   function Kind_Of (Source : Card) return Card_Kind is
     (Card_Kind'Val (Source (Head) mod 16))
   with
     Global => null,
     Pre    => Has_Kind (Source);

   --  Each surface of a multisine has its own signal. Otherwise each pair has.
   function Is_Single (Source : Card) return Boolean is
     (Source (Head) / 16 mod 16 = 1)
   with Global => null;

   function Has_Slot (Source : Card) return Boolean is
     (Source (Head) / 256 in 1 .. 8)
   with Global => null;

   function Slot_Of (Source : Card) return Slot is
     (Slot (Source (Head) / 256))
   with
     Global => null,
     Pre    => Has_Slot (Source);

   function Moves (Source : Card; Which : Test_Surface) return Boolean is
     (Source (Surfaces) / 2 ** Test_Surface'Pos (Which) mod 2 = 1)
   with Global => null;

   function Place_Of (Source : Card) return Input_Place is
     (case Source (Surfaces) and Place_Bits is
         when Stick_Place   => At_Stick,
         when Command_Place => At_Command,
         when others        => At_Servo)
   with Global => null;

   function Bank_Limit (Source : Card) return Limit is
     (Limit (Source (Attitude) mod 64))
   with Global => null;

   function Pitch_Limit (Source : Card) return Limit is
     (Limit (Source (Attitude) / 64))
   with Global => null;

   function Alpha_Limit (Source : Card) return Limit is
     (Limit (Source (Airflow) mod 64))
   with Global => null;

   function Load_Limit (Source : Card) return Limit is
     (Limit (Source (Airflow) / 64))
   with Global => null;

   --  The frames of a pulse, or of the whole sweep or multisine.
   subtype Time_Frames is Frame_Count range
     0 .. Frame_Count (4_095 * Frames_Per_Second / 100);

   function Frames_Of (Source : Card) return Time_Frames is
     (Integer (Source (Time)) * Frames_Per_Second / 100)
   with Global => null;

   --  The frames of the whole input.
   function Length_Of (Source : Card) return Frame_Count is
     (case Kind_Of (Source) is
         when Doublet           => 2 * Frames_Of (Source),
         when Three_Two_One_One => 7 * Frames_Of (Source),
         when others            => Frames_Of (Source))
   with
     Global => null,
     Pre    => Has_Kind (Source);

   --  Signals of a multisine

   subtype Signal_Number is Integer range 0 .. 5;

   --  The number of the surfaces, or pairs, before this one that move.
   function Signal_Of (Source : Card; Which : Test_Surface)
                       return Signal_Number
   is
     (if Is_Single (Source)
      then
        (if Which > Left_Aileron and then Moves (Source, Left_Aileron)
         then 1 else 0)
        + (if Which > Right_Aileron and then Moves (Source, Right_Aileron)
           then 1 else 0)
        + (if Which > Left_Elevator and then Moves (Source, Left_Elevator)
           then 1 else 0)
        + (if Which > Right_Elevator and then Moves (Source, Right_Elevator)
           then 1 else 0)
        + (if Which > Left_Rudder and then Moves (Source, Left_Rudder)
           then 1 else 0)
      else
        (if Which > Right_Aileron and then Moves (Source, Left_Aileron)
         then 1 else 0)
        + (if Which > Right_Elevator and then Moves (Source, Left_Elevator)
           then 1 else 0))
   with Global => null;

   subtype Signal_Count is Integer range 0 .. 6;

   function Signals_Of (Source : Card) return Signal_Count is
     (Signal_Of (Source, Right_Rudder)
      + (if Moves (Source, Right_Rudder) then 1 else 0))
   with Global => null;

   subtype Harmonic is Integer range 0 .. 255;

   function First_Harmonic (Source : Card) return Harmonic is
     (Integer (Source (Last)) / 16)
   with Global => null;

   subtype Sine_Number is Integer range 0 .. 15;

   function Sines_Of (Source : Card) return Sine_Number is
     (Integer (Source (Last)) mod 16)
   with Global => null;

   subtype Last_Number is Integer range -1 .. 344;

   function Last_Harmonic (Source : Card) return Last_Number is
     (First_Harmonic (Source) + Signals_Of (Source) * Sines_Of (Source) - 1)
   with Global => null;

   --  Permitted values

   --  The card moves something, and only what its place has. A surface's own
   --  input cannot be added to a stick.
   function Has_Inputs (Source : Card) return Boolean is
     ((Source (Surfaces) and Surface_Bits) /= 0
      and then
        (case Source (Surfaces) and Place_Bits is
            when 0             => True,
            when Stick_Place   => (Source (Surfaces) and No_Stick) = 0,
            when Command_Place => (Source (Surfaces) and No_Command) = 0,
            when others        => False))
   with Global => null;

   function Has_Limits (Source : Card) return Boolean is
     (Bank_Limit (Source) > 0
      and then Pitch_Limit (Source) > 0
      and then Alpha_Limit (Source) > 0
      and then Load_Limit (Source) > 0
      and then Source (Slowest) <= Source (Fastest))
   with Global => null;

   function Has_Pairs (Source : Card) return Boolean is
     (Moves (Source, Left_Aileron) = Moves (Source, Right_Aileron)
      and then Moves (Source, Left_Elevator) = Moves (Source, Right_Elevator)
      and then Moves (Source, Left_Rudder) = Moves (Source, Right_Rudder))
   with Global => null;

   function Has_Frequencies (Source : Card) return Boolean is
     (case Kind_Of (Source) is
         when Linear_Sweep =>
           Source (First) in Least_Sweep .. Most_Frequency
           and then Source (Last) in Least_Sweep .. Most_Frequency,
         when Exponential_Sweep =>
           Source (First) in Least_Sweep .. Most_Frequency
           and then Source (Last) in 1 .. Most_Octaves,
         when Multisine =>
           Source (First) in 1 .. Most_Base
           and then First_Harmonic (Source) >= 1
           and then Sines_Of (Source) in Sine_Count
           and then Signals_Of (Source) <= Most_Signals
           and then
             Integer (Source (First)) * Last_Harmonic (Source) <=
               Most_Frequency
           and then (Is_Single (Source) or else Has_Pairs (Source)),
         when others =>
           Source (First) = 0 and then Source (Last) = 0)
   with
     Global => null,
     Pre    => Has_Kind (Source);

   --  The card is one that the aircraft can run.
   function Is_Loaded (Source : Card) return Boolean is
     (Has_Kind (Source)
      and then Has_Slot (Source)
      and then Kind_Of (Source) in Signal_Kind
      and then Source (Head) / 16 mod 16 <=
                 (if Kind_Of (Source) = Multisine then 1 else 0)
      and then Has_Inputs (Source)
      and then Source (Amplitude) in 1 .. Most_Amplitude
      and then Frames_Of (Source) >= 1
      and then Has_Frequencies (Source)
      and then Has_Limits (Source))
   with Global => null;

   function Is_Order (Source : Card) return Boolean is
     (Has_Kind (Source)
      and then Has_Slot (Source)
      and then Kind_Of (Source) in Empty | Choose
      and then Source (Head) / 16 mod 16 = 0
      and then (for all Item in Surfaces .. Lowest => Source (Item) = 0))
   with Global => null;

   function Is_In_Range (Source : Card) return Boolean is
     (Is_Loaded (Source) or else Is_Order (Source))
   with Global => null;

end URV.Test_Cards;
