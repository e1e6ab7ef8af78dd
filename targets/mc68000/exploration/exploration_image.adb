--  SPDX-License-Identifier: Apache-2.0

with Exploration_Program;

procedure Exploration_Image is
begin
   Exploration_Program.Run;
end Exploration_Image;
