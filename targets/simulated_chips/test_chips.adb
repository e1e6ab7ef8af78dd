--  SPDX-License-Identifier: Apache-2.0

--  Runs the drivers beside simulated chips, on a host, with the contracts
--  executed (BRD-6, BRD-9). Events come between any two accesses: all plans of
--  up to two events at each of the first seven accesses, and a burst at each.
--
--  Prints a line for each test. Exit status: 0 when all passed.

with Ada.Assertions;   use Ada.Assertions;
with Ada.Command_Line; use Ada.Command_Line;
with Ada.Text_IO;
with Cortex_SysTick.Registers;
with Cortex_SysTick.Timers;
with MC68681.Channels;
with MC68681.Models;
with MC68681.Registers;
with MC68681.Timers;
with Simulated_Line;   use Simulated_Line;
with STM32_ADC.Conversions;
with STM32_ADC.Registers;
with STM32_PWM.Pulses;
with STM32_PWM.Registers;
with STM32_USART.Channels;
with STM32_USART.Registers;
with STM32_Watchdog.Registers;
with STM32_Watchdog.Timers;
with URVOS;            use URVOS;

procedure Test_Chips is

   pragma Assertion_Policy (Check);

   package DUART renames MC68681.Channels;
   package USART renames STM32_USART.Channels;

   --  A heard character of either chip.
   type Heard is record
      Is_There, Overrun : Boolean;
      Item              : Sent_Character;
   end record;

   --  The numbers of the characters and errors that a plan has shown.
   type Totals is record
      Heard, Lost, Overruns, Parity_Errors, Framing_Errors : Count := 0;

      --  The number of the character that comes next, if none is lost.
      Next : Natural := 0;
   end record;

   No_Events : constant Event_Plan := (others => 0);

   All_Passed : Boolean := True;

   --  Counts a character. It must be one of those that have arrived, after
   --  the last one, with its own errors.
   procedure Follow (Sums : in out Totals; Result : Heard);

   --  At the end of a plan: nothing was lost without a report, and the driver
   --  has counted each error.
   procedure Compare
     (Sums                                    : Totals;
      Overruns, Parity_Errors, Framing_Errors : Count);

   procedure Run
     (Name : String;
      Test : not null access procedure);

   procedure Try_All (Try : not null access procedure (Plan : Event_Plan));

   procedure Follow (Sums : in out Totals; Result : Heard) is
   begin
      if Result.Overrun then
         Sums.Overruns := Sums.Overruns + 1;
      end if;
      if Result.Is_There then
         while Sent (Sums.Next).Data /= Result.Item.Data loop
            Sums.Lost := Sums.Lost + 1;
            Sums.Next := Sums.Next + 1;
            pragma Assert (Sums.Next < Arrived);
         end loop;
         pragma Assert (Sent (Sums.Next) = Result.Item);
         Sums.Next := Sums.Next + 1;
         Sums.Heard := Sums.Heard + 1;
         if Result.Item.Wrong_Parity then
            Sums.Parity_Errors := Sums.Parity_Errors + 1;
         end if;
         if Result.Item.Wrong_Framing then
            Sums.Framing_Errors := Sums.Framing_Errors + 1;
         end if;
      end if;
   end Follow;

   procedure Compare
     (Sums                                    : Totals;
      Overruns, Parity_Errors, Framing_Errors : Count)
   is
      Lost : constant Count := Sums.Lost + Count (Arrived - Sums.Next);
   begin
      pragma Assert (Natural (Sums.Heard + Lost) = Arrived);
      pragma Assert ((Lost > 0) = (Sums.Overruns > 0));
      pragma Assert (Sums.Overruns <= Lost);
      pragma Assert (Overruns = Sums.Overruns);
      pragma Assert (Parity_Errors = Sums.Parity_Errors);
      pragma Assert (Framing_Errors = Sums.Framing_Errors);
   end Compare;

   procedure Run
     (Name : String;
      Test : not null access procedure) is
   begin
      Test.all;
      Ada.Text_IO.Put_Line ("passed: " & Name);
   exception
      when Assertion_Error =>
         All_Passed := False;
         Ada.Text_IO.Put_Line ("failed: " & Name);
   end Run;

   procedure Try_All (Try : not null access procedure (Plan : Event_Plan)) is
      Plan  : Event_Plan := No_Events;
      Rest  : Natural;
      Burst : Event_Plan;
   begin
      for Number in 0 .. 3 ** 7 - 1 loop
         Rest := Number;
         for Place in 1 .. 7 loop
            Plan (Place) := Rest mod 3;
            Rest := Rest / 3;
         end loop;
         Try (Plan);
      end loop;
      for Place in Access_Number loop
         Burst := No_Events;
         Burst (Place) := 9;
         Try (Burst);
      end loop;
   end Try_All;

   --  The MC68681

   procedure Set_Up_DUART;
   procedure Receive_From_DUART (Plan : Event_Plan);

   --  With a look before each character, and Receive only for faulty ones.
   procedure Look_At_DUART (Plan : Event_Plan);
   procedure Receive_From_DUART;
   procedure Send_To_DUART;
   procedure Take_Periods (Plan : Event_Plan);
   procedure Take_Periods;
   procedure Use_Interrupts;

   procedure Set_Up_DUART is
      use MC68681.Registers;
   begin
      Begin_Plan ((2, 0, 1, 0, 3, others => 1));
      DUART.Set_Up (MC68681.Line);
      pragma Assert (DUART.Is_Set_Up (State (MC68681.Line)));
   end Set_Up_DUART;

   procedure Receive_From_DUART (Plan : Event_Plan) is
      Counts : DUART.Error_Counts;
      Result : DUART.Reception;
      Sums   : Totals;
   begin
      Begin_Plan (No_Events);
      DUART.Set_Up (MC68681.Line);
      Begin_Plan (Plan);
      loop
         DUART.Receive (MC68681.Line, Counts, Result);
         Follow
           (Sums,
            (Result.Is_There, Result.Overrun,
             (Result.Data, Result.Wrong_Parity, Result.Wrong_Framing)));
         exit when Is_Over and then not Result.Is_There;
      end loop;
      Compare
        (Sums, Counts.Overruns, Counts.Parity_Errors, Counts.Framing_Errors);
   end Receive_From_DUART;

   procedure Look_At_DUART (Plan : Event_Plan) is
      use type DUART.Arrival;
      Counts         : DUART.Error_Counts;
      Line           : DUART.Arrival;
      Result         : DUART.Reception;
      Sums           : Totals;
      Unused_Is_Free : Boolean;
   begin
      Begin_Plan (No_Events);
      DUART.Set_Up (MC68681.Line);
      Begin_Plan (Plan);
      loop
         DUART.Look (MC68681.Line, Line, Unused_Is_Free);
         exit when Is_Over and then Line = DUART.Nothing;
         if Line = DUART.Good then
            DUART.Take (MC68681.Line, Result.Data);
            Follow (Sums, (True, False, (Result.Data, False, False)));
         elsif Line = DUART.Faulty then
            DUART.Receive (MC68681.Line, Counts, Result);
            Follow
              (Sums,
               (Result.Is_There, Result.Overrun,
                (Result.Data, Result.Wrong_Parity, Result.Wrong_Framing)));
         end if;
      end loop;
      Compare
        (Sums, Counts.Overruns, Counts.Parity_Errors, Counts.Framing_Errors);
   end Look_At_DUART;

   procedure Receive_From_DUART is
   begin
      Try_All (Receive_From_DUART'Access);
      Try_All (Look_At_DUART'Access);
   end Receive_From_DUART;

   procedure Send_To_DUART is
      use MC68681.Registers;
      Is_Free : Boolean;
      Refused : Boolean := False;
   begin
      Begin_Plan (No_Events);
      DUART.Set_Up (MC68681.Line);
      DUART.Look_At_Sender (MC68681.Line, Is_Free);
      pragma Assert (not Is_Free);
      Begin_Plan ((1, others => 0));
      DUART.Look_At_Sender (MC68681.Line, Is_Free);
      pragma Assert (Is_Free);
      DUART.Send (MC68681.Line, 77);
      begin
         DUART.Send (MC68681.Line, 78);
      exception
         when Assertion_Error => Refused := True;
      end;
      pragma Assert (Refused and then State (MC68681.Line).Last_Sent = 77);
   end Send_To_DUART;

   --  Each end of a period is reported; several may be reported as one.
   procedure Take_Periods (Plan : Event_Plan) is
      use MC68681.Timers;
      Ended    : Natural := 0;
      Reported : Natural := 0;
      Is_Due   : Boolean;
   begin
      Begin_Plan (No_Events);
      Start (MC68681.Clock_Chip, 4_000);
      Begin_Plan (Plan);
      loop
         Take_Period (MC68681.Clock_Chip, Is_Due);
         Reported := Reported + (if Is_Due then 1 else 0);
         exit when Is_Over and then not Is_Due;
      end loop;
      for Events of Plan loop
         Ended := Ended + Events;
      end loop;
      pragma Assert ((Ended > 0) = (Reported > 0));
      pragma Assert (Reported <= Ended);
   end Take_Periods;

   procedure Take_Periods is
   begin
      Try_All (Take_Periods'Access);
   end Take_Periods;

   procedure Use_Interrupts is
      use MC68681;
      use MC68681.Registers;
   begin
      Begin_Plan ((others => 1));
      MC68681.Timers.Start (Clock_Chip, 4_001);
      MC68681.Timers.Use_Interrupts (Clock_Chip, 16#42#, Receiver => False);
      pragma Assert
        (MC68681.Models.Count_Of (State (Clock_Chip)) = 4_001
         and then State (Clock_Chip).Vector = 16#42#
         and then State (Clock_Chip).Interrupts.Timer
         and then not State (Clock_Chip).Interrupts.Receiver_A);
   end Use_Interrupts;

   --  The STM32's serial port

   procedure Set_Up_USART;
   procedure Receive_From_USART (Plan : Event_Plan);
   procedure Receive_From_USART;
   procedure Send_To_USART;

   procedure Set_Up_USART is
      use STM32_USART;
      use STM32_USART.Registers;
   begin
      Begin_Plan ((2, 0, 1, 0, others => 1));
      USART.Set_Up (Line, Bit_Time => 336, Interrupt => True);
      pragma Assert
        (State (Line).Settings = USART.Line_Settings (True)
         and then State (Line).More_Settings.Stop = Two
         and then State (Line).Bit_Time = 336);
   end Set_Up_USART;

   --  A character of an earlier plan may still be in the data register.
   procedure Receive_From_USART (Plan : Event_Plan) is
      Counts : USART.Error_Counts;
      Result : USART.Reception;
      Sums   : Totals;
   begin
      Begin_Plan (No_Events);
      USART.Set_Up (STM32_USART.Line, Bit_Time => 336, Interrupt => True);
      loop
         USART.Receive (STM32_USART.Line, Counts, Result);
         exit when not Result.Is_There and then not Result.Overrun;
      end loop;
      Counts := (others => <>);
      Begin_Plan (Plan);
      loop
         USART.Receive (STM32_USART.Line, Counts, Result);
         Follow
           (Sums,
            (Result.Is_There, Result.Overrun,
             (Result.Data, Result.Wrong_Parity, Result.Wrong_Framing)));
         exit when Is_Over
           and then not Result.Is_There and then not Result.Overrun;
      end loop;
      Compare
        (Sums, Counts.Overruns, Counts.Parity_Errors, Counts.Framing_Errors);
   end Receive_From_USART;

   procedure Receive_From_USART is
   begin
      Try_All (Receive_From_USART'Access);
   end Receive_From_USART;

   procedure Send_To_USART is
      use STM32_USART.Registers;
      Is_Free : Boolean;
      Refused : Boolean := False;
      Counts  : USART.Error_Counts;
      Result  : USART.Reception;
   begin
      Begin_Plan (No_Events);
      USART.Look_At_Sender (STM32_USART.Line, Is_Free);
      pragma Assert (Is_Free);
      USART.Send (STM32_USART.Line, 77);
      begin
         USART.Send (STM32_USART.Line, 78);
      exception
         when Assertion_Error => Refused := True;
      end;
      pragma Assert (Refused and then State (STM32_USART.Line).Last_Sent = 77);

      --  The second character has a wrong parity, which a write would hide.
      Begin_Plan ((1, 0, 1, others => 0));
      USART.Receive (STM32_USART.Line, Counts, Result);
      pragma Assert (Result.Is_There and then not Result.Wrong_Parity);
      USART.Look_At_Sender (STM32_USART.Line, Is_Free);
      pragma Assert (not Is_Free);
      USART.Receive (STM32_USART.Line, Counts, Result);
      pragma Assert (Result.Wrong_Parity);
      USART.Look_At_Sender (STM32_USART.Line, Is_Free);
      pragma Assert (Is_Free);
   end Send_To_USART;

   --  The STM32's watchdog

   procedure Start_Watchdog;
   procedure Feed_Watchdog;

   procedure Start_Watchdog is
      use STM32_Watchdog;
      use STM32_Watchdog.Registers;
      Reload  : constant Reload_Value := Timers.Reload_For (100);
      Refused : Boolean := False;
   begin
      Begin_Plan ((0, 1, 0, 2, others => 0));
      pragma Assert
        (Timers.Least_Time (Reload) >= 100
         and then Timers.Least_Time (Reload - 2) < 100
         and then Timers.Greatest_Time (Reload) = 281);
      begin
         Write_Reload (Reload);
      exception
         when Assertion_Error => Refused := True;
      end;
      pragma Assert (Refused);
      Timers.Start (Reload);
      pragma Assert
        (State.Runs
         and then State.Divider = By_32
         and then State.Reload = Reload
         and then State.Feeds = 1);
   end Start_Watchdog;

   procedure Feed_Watchdog is
      use STM32_Watchdog;
      use STM32_Watchdog.Registers;
      Before : constant Event_Number := State.Feeds with Ghost;
   begin
      Begin_Plan (No_Events);
      for Number in Event_Number range 1 .. 3 loop
         Timers.Feed;
         pragma Assert (State.Feeds = Before + Number and then State.Runs);
      end loop;
   end Feed_Watchdog;

   --  The STM32's converter

   procedure Set_Up_Converter;
   procedure Convert (Plan : Event_Plan);
   procedure Convert;
   procedure Convert_Untaken;

   procedure Set_Up_Converter is
      use STM32_ADC;
      use STM32_ADC.Registers;
      Refused : Boolean := False;
   begin
      Begin_Plan (No_Events);
      Conversions.Set_Up (Cycles_56, Interrupt => True);
      Conversions.Start (3);
      begin
         Conversions.Start (4);
      exception
         when Assertion_Error => Refused := True;
      end;
      pragma Assert (Refused and then State.Sampled = 3);
      Begin_Plan ((2, 0, 1, others => 1));
      Conversions.Set_Up (Cycles_84, Interrupt => True);
      pragma Assert
        (Conversions.Is_Ready (State)
         and then State.Settings.End_Interrupt
         and then State.Settings.Overrun_Interrupt
         and then State.Sampling = Cycles_84);
   end Set_Up_Converter;

   --  A start for each value: each is that of its channel, and none is lost.
   procedure Convert (Plan : Event_Plan) is
      use STM32_ADC;
      use STM32_ADC.Registers;
      Result : Conversions.Reception;
      Before : constant Event_Number := State.Losses with Ghost;
   begin
      Begin_Plan (No_Events);
      Conversions.Set_Up (Cycles_56, Interrupt => True);
      Begin_Plan (Plan);
      for Channel in Channel_Number range 0 .. 3 loop
         Conversions.Start (Channel);
         for Look in 1 .. 4 loop
            Conversions.Take (Result);
            exit when Result.Is_There;
         end loop;
         exit when not Result.Is_There;
         pragma Assert (not Result.Overrun);
         pragma Assert (Channel_Number (Result.Value mod 16) = Channel);
      end loop;
      pragma Assert (State.Losses = Before);
   end Convert;

   procedure Convert is
   begin
      Try_All (Convert'Access);
   end Convert;

   --  A second start before the first value was taken: an overrun, reported
   --  once, and no value of an unknown channel.
   procedure Convert_Untaken is
      use STM32_ADC;
      use STM32_ADC.Registers;
      Result         : Conversions.Reception;
      Values, Losses : Natural;
   begin
      for Events in 0 .. 3 ** 6 - 1 loop
         declare
            Plan : Event_Plan := No_Events;
            Rest : Natural := Events;
         begin
            Begin_Plan (No_Events);
            Conversions.Set_Up (Cycles_56, Interrupt => False);
            Conversions.Start (1);
            for Place in 1 .. 6 loop
               Plan (Place) := Rest mod 3;
               Rest := Rest / 3;
            end loop;
            Begin_Plan (Plan);
            Values := 0;
            Losses := 0;
            if Plan (1) > 0 then
               Write_Control_1 ((others => False));
               Conversions.Start (2);
            end if;
            for Look in 1 .. 4 loop
               Conversions.Take (Result);
               if Result.Is_There then
                  pragma Assert
                    (Result.Value mod 16 =
                       (if Plan (1) > 0 and then Values + Losses > 0 then 2
                        else 1));
                  Values := Values + 1;
               end if;
               if Result.Overrun then
                  Losses := Losses + 1;
               end if;
            end loop;
            pragma Assert (Losses <= 1 and then Values <= 2);
            pragma Assert (not State.Overrun);
         end;
      end loop;
   end Convert_Untaken;

   --  The servos' pulses

   procedure Start_Pulses;
   procedure Change_Pulses;
   procedure Limit_Pulses;

   --  The simulated chip demands safe outputs at each access.
   procedure Start_Pulses is
      use STM32_PWM;
      use STM32_PWM.Registers;
   begin
      for Timer in Timer_Name loop
         Begin_Plan ((0, 1, 0, 2, others => 1));
         Pulses.Set_Up (Timer, (others => Pulse_Of (16#800#)));
         pragma Assert (Pulses.Is_Set_Up (State (Timer)));
         Begin_Plan ((others => 1));
         Pulses.Set_Up
           (Timer, (4 => Pulse_Of (0), others => Pulse_Of (16#FFF#)));
         pragma Assert
           (Pulses.Is_Set_Up (State (Timer))
            and then State (Timer).In_Use.Compare (1) = 2_000
            and then State (Timer).In_Use.Compare (4) = 1_000);
      end loop;
   end Start_Pulses;

   --  A written pulse waits for the end of the period.
   procedure Change_Pulses is
      use STM32_PWM;
      use STM32_PWM.Registers;
      Refused : Natural := 0;
   begin
      Begin_Plan (No_Events);
      Pulses.Set_Up (Timer_3, (others => 1_500));
      Pulses.Write (Timer_3, 2, 1_250);
      pragma Assert
        (State (Timer_3).In_Use.Compare (2) = 1_500
         and then State (Timer_3).Written.Compare (2) = 1_250);
      Begin_Plan ((1, others => 0));
      Pulses.Write (Timer_3, 1, 1_750);
      pragma Assert
        (State (Timer_3).In_Use.Compare (2) = 1_250
         and then State (Timer_3).In_Use.Compare (1) = 1_500);
      begin
         Write_Compare (Timer_3, 1, 2_001);
      exception
         when Assertion_Error => Refused := Refused + 1;
      end;
      begin
         Write_Reload (Timer_3, 20_000);
      exception
         when Assertion_Error => Refused := Refused + 1;
      end;
      pragma Assert (Refused = 2);
   end Change_Pulses;

   procedure Limit_Pulses is
      use STM32_PWM;
      Last : Pulse := Pulse'First;
   begin
      for Value in Word range 0 .. 16#1FFF# loop
         pragma Assert (Pulse_Of (Value) in Last .. Last + 1);
         Last := Pulse_Of (Value);
      end loop;
      pragma Assert (Last = Pulse'Last);
   end Limit_Pulses;

   --  The processor's timer

   procedure Start_SysTick;
   procedure Take_SysTick_Periods (Plan : Event_Plan);
   procedure Take_SysTick_Periods;

   procedure Start_SysTick is
      use Cortex_SysTick;
      use Cortex_SysTick.Registers;
      Before : Event_Number with Ghost;
   begin
      Begin_Plan ((0, 3, others => 1));
      Timers.Start (336_000);
      Timers.Start (16_128);
      pragma Assert (State.In_Use = 16_127 and then State.Counts);
      Begin_Plan (No_Events);
      Timers.Set_Next (4_000);
      pragma Assert (State.In_Use = 16_127 and then State.Reload = 3_999);
      Timers.Stop;
      Before := State.Periods;
      Begin_Plan ((others => 1));
      Timers.Resume;
      pragma Assert (State.Periods = Before and then State.Interrupts);
   end Start_SysTick;

   --  Each end of a period is reported; several may be reported as one.
   procedure Take_SysTick_Periods (Plan : Event_Plan) is
      use Cortex_SysTick;
      Ended    : Natural := 0;
      Reported : Natural := 0;
      Is_Due   : Boolean;
   begin
      Begin_Plan (No_Events);
      Timers.Start (4_000);
      Begin_Plan (Plan);
      loop
         Timers.Take_Period (Is_Due);
         Reported := Reported + (if Is_Due then 1 else 0);
         exit when Is_Over and then not Is_Due;
      end loop;
      for Events of Plan loop
         Ended := Ended + (if Events > 0 then 1 else 0);
      end loop;
      pragma Assert (Reported = Ended);
   end Take_SysTick_Periods;

   procedure Take_SysTick_Periods is
   begin
      Try_All (Take_SysTick_Periods'Access);
   end Take_SysTick_Periods;

begin
   Run ("MC68681: set up while characters arrive", Set_Up_DUART'Access);
   Run ("MC68681: characters between any two accesses",
        Receive_From_DUART'Access);
   Run ("MC68681: a character is given only to a free sender",
        Send_To_DUART'Access);
   Run ("MC68681: a timer's periods between any two accesses",
        Take_Periods'Access);
   Run ("MC68681: a timer's count and interrupts", Use_Interrupts'Access);
   Run ("STM32 USART: set up while characters arrive", Set_Up_USART'Access);
   Run ("STM32 USART: characters between any two accesses",
        Receive_From_USART'Access);
   Run ("STM32 USART: a character is given only to a free sender",
        Send_To_USART'Access);
   Run ("STM32 watchdog: started with its time, and locked",
        Start_Watchdog'Access);
   Run ("STM32 watchdog: each feed begins its time again",
        Feed_Watchdog'Access);
   Run ("STM32 ADC: set up during a conversion", Set_Up_Converter'Access);
   Run ("STM32 ADC: a conversion ends between any two accesses",
        Convert'Access);
   Run ("STM32 ADC: a value that is not taken is an overrun",
        Convert_Untaken'Access);
   Run ("STM32 PWM: no output before the pulses are right",
        Start_Pulses'Access);
   Run ("STM32 PWM: a pulse changes at the end of its period",
        Change_Pulses'Access);
   Run ("STM32 PWM: pulses of 1 to 2 ms for all words", Limit_Pulses'Access);
   Run ("SysTick: started, changed and stopped", Start_SysTick'Access);
   Run ("SysTick: a timer's periods between any two accesses",
        Take_SysTick_Periods'Access);
   Set_Exit_Status (if All_Passed then Success else Failure);
end Test_Chips;
