--  SPDX-License-Identifier: Apache-2.0

--  Runs the drivers beside simulated chips, on a host, with the contracts
--  executed (BRD-6). Events come between any two accesses: all plans of up to
--  two events at each of the first seven accesses, and a burst at each.
--
--  Prints a line for each test. Exit status: 0 when all passed.

with Ada.Assertions;   use Ada.Assertions;
with Ada.Command_Line; use Ada.Command_Line;
with Ada.Text_IO;
with MC68681.Channels;
with MC68681.Models;
with MC68681.Registers;
with MC68681.Timers;
with Simulated_Line;   use Simulated_Line;
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

   procedure Receive_From_DUART is
   begin
      Try_All (Receive_From_DUART'Access);
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
   Set_Exit_Status (if All_Passed then Success else Failure);
end Test_Chips;
