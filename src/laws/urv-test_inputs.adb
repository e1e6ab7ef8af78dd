--  SPDX-License-Identifier: Apache-2.0

package body URV.Test_Inputs with SPARK_Mode is

   --  Values of narrow types, so that their products fit.

   --  Neighbours in the table of sines differ by less than 512.
   subtype Sine_Step is Integer range -511 .. 511;

   subtype Harmonic_Number is Integer range 0 .. 400;
   subtype Sine_Sum is
     Integer range -Sine_Count'Last * Unit .. Sine_Count'Last * Unit;
   subtype Size is Integer range 0 .. Most_Amplitude;
   subtype Span is Integer range -Most_Frequency .. Most_Frequency;

   function Sine (Phase : Phase_Number) return Unit_Value is
      Places : constant := Sine_Place'Last;
      Place  : constant Integer := Phase * Places / Cycle;
      Rest   : constant Phase_Number := Phase * Places mod Cycle;
      Before : constant Unit_Value := Sines (Place);
      After  : constant Unit_Value := Sines (Place + 1);
      Slope  : constant Sine_Step := Within (After - Before, -511, 511);
   begin
      return Within (Before + Slope * Rest / Cycle, -Unit, Unit);
   end Sine;

   --  The frequency of an exponential sweep after Octaves of 4096 parts.
   function Raised (Base : Fine_Frequency; Octaves : Natural)
                    return Fine_Frequency
   with
     Global => null,
     Pre    => Octaves <= 64 * Most_Octaves;

   function Raised (Base : Fine_Frequency; Octaves : Natural)
                    return Fine_Frequency
   is
      Part   : constant Integer := Octaves mod 4_096;
      Before : constant Power := Powers (Part / 64);
      After  : constant Power := Powers (Part / 64 + 1);
      Factor : constant Integer :=
        Before + Within (After - Before, 0, 64) * (Part mod 64) / 64;
      Value  : Integer := Base * Within (Factor, 0, 4_096) / Power_Unit;
   begin
      for Octave in 1 .. Octaves / 4_096 loop
         Value := 2 * Within (Value, 0, Fine_Frequency'Last);
         pragma Loop_Invariant (Value in 0 .. 2 * Fine_Frequency'Last);
      end loop;
      return Within (Value, 0, Fine_Frequency'Last);
   end Raised;

   function Frequency_At (Source : Card; Frame : Frame_Count)
                          return Fine_Frequency
   is
      Begin_At : constant Integer := Integer (Source (First));
      Last_One : constant Integer := Integer (Source (Last));
      Length   : constant Frame_Count := Length_Of (Source);
   begin
      case Kind_Of (Source) is
         when Linear_Sweep =>
            declare
               Moved : constant Span := Last_One - Begin_At;
               Since : constant Time_Frames := Frame;
               Part  : constant Integer :=
                 Moved * Since * Fine_Parts / Length;
            begin
               return Within
                 (Begin_At * Fine_Parts
                    + Integer'Max
                        (Integer'Min (Part, Fine_Frequency'Last),
                         -Fine_Frequency'Last),
                  0, Fine_Frequency'Last);
            end;
         when Exponential_Sweep =>
            pragma Assert (Frame < 4_096);
            return Raised
              (Begin_At * Fine_Parts,
               Within
                 (Last_One * 64 * Frame / Length, 0, 64 * Most_Octaves));
         when Multisine =>
            return Begin_At * Fine_Parts;
         when others =>
            return 0;
      end case;
   end Frequency_At;

   --  The value of a pulse.
   function Pulse (Kind : Pulses; Frame, Width : Frame_Count)
                   return Unit_Value
   is
     (case Kind is
         when Step              => Unit,
         when Doublet           => (if Frame < Width then Unit else -Unit),
         when Three_Two_One_One =>
           (if Frame < 3 * Width then Unit
            elsif Frame < 5 * Width then -Unit
            elsif Frame < 6 * Width then Unit
            else -Unit))
   with
     Global => null,
     Pre    => Width in Time_Frames;

   --  Schroeder's phase of a sine, counted from 0.
   function Offset (Place : Natural; Count : Sine_Count) return Phase_Number
   is
     ((-(Place * (Place - 1) * Cycle / (2 * Count))) mod Cycle)
   with
     Global => null,
     Pre    => Place < Count;

   --  The sum of the sines of a signal, by its share.
   function Sum_Of_Sines
     (Source : Card; Phase : Phase_Number; Which : Test_Surface)
      return Unit_Value
   with
     Global => null,
     Pre    =>
       Is_Loaded (Source) and then Kind_Of (Source) = Multisine;

   function Sum_Of_Sines
     (Source : Card; Phase : Phase_Number; Which : Test_Surface)
      return Unit_Value
   is
      Count    : constant Sine_Count := Sines_Of (Source);
      Signals  : constant Signal_Count := Signals_Of (Source);
      Harmonic : Natural :=
        First_Harmonic (Source) + Signal_Of (Source, Which);
      Sum      : Integer := 0;
      Total    : Sine_Sum;
   begin
      for Place in 0 .. Count - 1 loop
         pragma Loop_Invariant
           (Harmonic <= 260 + Place * Signal_Count'Last
            and then abs Sum <= Place * Unit);
         declare
            Now : constant Harmonic_Number := Harmonic;
         begin
            Sum := Sum
              + Sine ((Now * Phase mod Cycle + Offset (Place, Count))
                      mod Cycle);
         end;
         Harmonic := Harmonic + Signals;
      end loop;
      Total := Sum;
      return Within (Total * Shares (Count) / Share_Unit, -Unit, Unit);
   end Sum_Of_Sines;

   function Signal
     (Source : Card;
      Frame  : Frame_Count;
      Phase  : Phase_Number;
      Which  : Test_Surface) return Increment
   is
      Most  : constant Size := Size (Source (Amplitude));
      Value : constant Unit_Value :=
        (case Kind_Of (Source) is
            when Pulses    =>
              Pulse (Kind_Of (Source), Frame, Frames_Of (Source)),
            when Linear_Sweep | Exponential_Sweep => Sine (Phase),
            when Multisine => Sum_Of_Sines (Source, Phase, Which),
            when others    => 0);
   begin
      if not Moves (Source, Which) then
         return 0;
      end if;
      return Within (Value * Most / Unit, -Most, Most);
   end Signal;

end URV.Test_Inputs;
