--  SPDX-License-Identifier: Apache-2.0

package body Waiting_Rig is

   Per_Tick : Natural := 0;
   Run      : Action  := null;

   procedure Begin_At
     (Start          : Clock_Tick;
      Exits_Per_Tick : Natural;
      Others_Run     : Action := null)
   is
   begin
      Now      := Start;
      Exits    := 0;
      Per_Tick := Exits_Per_Tick;
      Run      := Others_Run;
   end Begin_At;

   procedure Exit_Processor is
   begin
      Exits := Exits + 1;
      if Per_Tick > 0 and then Exits mod Per_Tick = 0 then
         Now := Advanced (Now);
      end if;
      if Run /= null then
         Run.all;
      end if;
   end Exit_Processor;

end Waiting_Rig;
