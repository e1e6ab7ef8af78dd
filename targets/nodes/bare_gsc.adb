--  SPDX-License-Identifier: Apache-2.0

with Bare_Memories;
pragma Unreferenced (Bare_Memories);
with GSC.Bare_Metal;
with Last_Chance;
with URV.CORE_Memory;
pragma Unreferenced (Last_Chance);
with Machine_Needs;
pragma Unreferenced (Machine_Needs);
with Machine_Texts; use Machine_Texts;
with Node_Programs;
with Targets;
with Telemetry;
with URVOS;         use URVOS;
with URVOS.Starts;  use URVOS.Starts;

package body Bare_GSC is

   package Node renames GSC.Bare_Metal;

   procedure Begin_Start (Condition : Start_Condition);

   procedure Begin_Start (Condition : Start_Condition) is
   begin
      Node.Begin_Start (Condition, GSC.Schedule.Contents);
   end Begin_Start;

   package Program is new Node_Programs
     (Name            => "GSC",
      AD_Board        => GSC.AD_Board,
      Telemetry_Board => GSC.Telemetry_Board,
      Node            => Node,
      Begin_Start     => Begin_Start,
      AD_Interrupt    => GSC.ADINT.Handle_Interrupt);

   procedure Run (Condition : Integer_32) is
   begin
      Program.Run (if Condition = 2 then Processor_Restart else Warm_Reset);
   end Run;

   procedure Start is
   begin
      Targets.Keep_Memory;
      Program.Run (Cold_Start);
   end Start;

   procedure On_Tick is
   begin
      Program.On_Tick;
   end On_Tick;

   procedure On_Character_Time is
   begin
      Program.On_Character_Time;
   end On_Character_Time;

   procedure On_Character (Data : Unsigned_32; Damaged : Unsigned_32) is
   begin
      Program.On_Character (Byte (Data and 255), Damaged /= 0);
   end On_Character;

   procedure On_Free_Sender is
   begin
      Program.On_Free_Sender;
   end On_Free_Sender;

   procedure On_Converted (Value : Unsigned_32) is
   begin
      Program.On_Converted (Word (Value and 16#FFF#));
   end On_Converted;

   procedure Configure (Flags : Unsigned_32; Line_Delay : Unsigned_32) is
      pragma Unreferenced (Flags);
   begin
      GSC.Telemetry_Board.Set_Round_Trip
        (Telemetry.Round_Trip_Of (Integer (Line_Delay)));
   end Configure;

   procedure Put_Row is
      CORE : constant URV.CORE_Memory.Memory := GSC.CORE_Memory.Contents;

   begin
      for Each of CORE.Uplink loop
         Put_Word (Unsigned_16 (Each));
      end loop;
      for Each of CORE.Downlink loop
         Put_Word (Unsigned_16 (Each));
      end loop;
      for Each of CORE.Status loop
         Put_Word (Unsigned_16 (Each));
      end loop;

      Put_Line;
   end Put_Row;

   procedure Put_Counts is
   begin
      Program.Put_Counts;
   end Put_Counts;

end Bare_GSC;
