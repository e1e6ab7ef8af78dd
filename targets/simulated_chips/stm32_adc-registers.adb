--  SPDX-License-Identifier: Apache-2.0

--  A simulated converter. Before each access an event of Simulated_Line ends
--  the conversion under way.

with Simulated_Line;

package body STM32_ADC.Registers with SPARK_Mode => Off is

   Present : Converter_Model :=
     (Settings                         => (others => False),
      More                             => (others => False),
      Sampling                         => Cycles_3,
      Channel | Sampled                => 0,
      Started | Present | Losses       => 0,
      Converting | Converted | Overrun => False);

   --  The channel of each conversion, by its number modulo 256.
   Channels : array (Event_Number range 0 .. 255) of Channel_Number :=
     (others => 0);

   function Result_Of (Number : Event_Number) return Converted_Value is
     (Word (Number mod 256) * 16 + Word (Channels (Number mod 256)));

   procedure Advance;

   procedure Advance is
      Events    : Simulated_Line.Event_Count;
      Keeps_Old : Boolean;
   begin
      Simulated_Line.Begin_Access (Events);
      if Events > 0 and then Present.Converting then
         --  One of the two values is lost.
         Keeps_Old := Present.Converted and then Events mod 2 = 0;
         if Present.Converted then
            Present.Losses := Present.Losses + 1;
            Present.Overrun := True;
         end if;
         if not Keeps_Old then
            Present.Present := Present.Started;
         end if;
         Present.Converting := False;
         Present.Converted := True;
      end if;
   end Advance;

   function State return Converter_Model is (Present);

   function Value_Of (Number : Event_Number) return Converted_Value is
     (Result_Of (Number));

   procedure Write_Status (Value : Status) is
   begin
      Advance;
      if not Value.Converted then
         Present.Converted := False;
      end if;
      if not Value.Overrun then
         Present.Overrun := False;
      end if;
   end Write_Status;

   procedure Read_Status (Item : out Status) is
   begin
      Advance;
      Item :=
        (Converted => Present.Converted,
         Started   => Present.Converting,
         Overrun   => Present.Overrun);
   end Read_Status;

   procedure Write_Control_1 (Value : Control_1) is
   begin
      Advance;
      Present.Settings := Value;
   end Write_Control_1;

   procedure Write_Control_2 (Value : Control_2) is
   begin
      Advance;
      Present.More := Value;
      if not Value.Is_On then
         Present.Converting := False;
      end if;
   end Write_Control_2;

   procedure Write_Sampling (Value : Sampling_Time) is
   begin
      Advance;
      Present.Sampling := Value;
   end Write_Sampling;

   procedure Write_Channel (Value : Channel_Number) is
   begin
      Advance;
      Present.Channel := Value;
   end Write_Channel;

   procedure Write_Start is
   begin
      Advance;
      Present := With_Start (Present);
      Channels (Present.Started mod 256) := Present.Sampled;
   end Write_Start;

   procedure Read_Data (Data : out Converted_Value) is
   begin
      Advance;
      Data := Result_Of (Present.Present);
      Present.Converted := False;
   end Read_Data;

end STM32_ADC.Registers;
