--  SPDX-License-Identifier: Apache-2.0

with GNAT.OS_Lib;
with Interfaces.C_Streams;

with Host.Text_Numbers;
with Sim.Wall_Clock;

package body Sim.Progress is

   --  The length of a flight before the bar appears, and the interval at which
   --  it is then drawn.
   Draw_After : constant Duration := 1.0;
   Interval   : constant Duration := 0.2;

   --  The clock is read once in this number of calls: three times a second in
   --  a flight at the pace of real time.
   Calls_A_Look : constant := 16;

   Bar_Width : constant := 30;

   Standard_Output : constant := 1;
   Standard_Error  : constant := 2;

   Return_And_Clear : constant String :=
     ASCII.CR & ASCII.ESC & "[K";

   Is_On     : Boolean := False;
   Is_Drawn  : Boolean := False;
   Calls     : Natural := 0;
   Whole     : Microseconds := 1;
   Began     : Duration;
   Next_Draw : Duration;

   procedure Put (Text : String);

   --  Draws the bar if it is time to.
   procedure Look (Time : Microseconds);

   procedure Put (Text : String) is
      Written : Integer;
   begin
      Written :=
        GNAT.OS_Lib.Write
          (GNAT.OS_Lib.Standerr, Text'Address, Text'Length);

      --  A failure to draw the bar does not stop a flight.
      pragma Unreferenced (Written);
   end Put;

   procedure Start
     (Length : Microseconds;
      Wanted : Boolean;
      Beside : Boolean := False)
   is
      use Interfaces.C_Streams;
   begin
      Is_On :=
        Wanted and then Length > 0
        and then isatty (Standard_Error) /= 0
        and then not (Beside and then isatty (Standard_Output) /= 0);
      Is_Drawn  := False;
      Calls     := 0;
      Whole     := Microseconds'Max (Length, 1);
      Began     := Wall_Clock.Now;
      Next_Draw := Began + Draw_After;
   end Start;

   procedure Look (Time : Microseconds) is
      Now : constant Duration := Wall_Clock.Now;
   begin
      if Now < Next_Draw then
         return;
      end if;
      Next_Draw := Now + Interval;
      Is_Drawn  := True;

      declare
         Flown   : constant Microseconds := Microseconds'Min (Time, Whole);
         Full    : constant Natural := Natural (Flown * Bar_Width / Whole);
         Elapsed : constant Duration := Duration'Max (Now - Began, 0.001);
         Speed   : constant Long_Float :=
           Long_Float (Flown) / 1.0E6 / Long_Float (Elapsed);

         function Image (Value : Microseconds) return String is
           (Text_Numbers.Image (Long_Long_Integer (Value)));
      begin
         Put
           (Return_And_Clear
            & "[" & (1 .. Full => '#') & (Full + 1 .. Bar_Width => '.')
            & "] " & Image (Flown * 100 / Whole) & " %  "
            & Image (Flown / 1_000_000) & " of "
            & Image (Whole / 1_000_000) & " s, "
            & Image (Microseconds (Speed)) & " times real time");
      end;
   end Look;

   procedure Show (Time : Microseconds) is
   begin
      if Is_On then
         Calls := Calls + 1;
         if Calls = Calls_A_Look then
            Calls := 0;
            Look (Time);
         end if;
      end if;
   end Show;

   procedure Stop is
   begin
      if Is_Drawn then
         Put (Return_And_Clear);
      end if;
      Is_On    := False;
      Is_Drawn := False;
   end Stop;

end Sim.Progress;
