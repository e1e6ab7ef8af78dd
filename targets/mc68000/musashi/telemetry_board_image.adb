--  SPDX-License-Identifier: Apache-2.0

with Telemetry_Board_Program;

procedure Telemetry_Board_Image is
begin
   Telemetry_Board_Program.Power_Up;
end Telemetry_Board_Image;
