--  SPDX-License-Identifier: Apache-2.0

with GSC.Bare_Metal;
with Node_Programs;
with URVOS.Starts; use URVOS.Starts;

package body Bare_GSC is

   procedure Begin_Start (Condition : Start_Condition);

   procedure Begin_Start (Condition : Start_Condition) is
   begin
      GSC.Bare_Metal.Begin_Start (Condition, GSC.Schedule.Contents);
   end Begin_Start;

   package Program is new Node_Programs
     (Name            => "GSC",
      AD_Board        => GSC.AD_Board,
      Telemetry_Board => GSC.Telemetry_Board,
      Sealing         => GSC.Sealing,
      CORE_Memory     => GSC.CORE_Memory,
      Node_Status     => GSC.Status,
      Errors          => GSC.Errors,
      Node            => GSC.Bare_Metal,
      Begin_Start     => Begin_Start,
      Handle_End      => GSC.ADINT.Handle_End);

   procedure Start is
   begin
      Program.Start;
   end Start;

end Bare_GSC;
