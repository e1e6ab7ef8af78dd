--  SPDX-License-Identifier: Apache-2.0

with MCS;
with URV.Laws; use URV.Laws;

package body Law_Rig is

   procedure Fly
     (Frames   : Positive;
      Sensors  : Downlink_Buffer := Level;
      Commands : Uplink_Buffer   := Sticks)
   is
      Unused_Success : Boolean;
      Unused_Fresh   : Boolean;
      Unused_Item    : Uplink_Buffer;
   begin
      MCS.Law_Settings.Write ((Laws_Off with delta On => True));
      for Frame in 1 .. Frames loop
         MCS.Commands_Variable.Send (Commands, Unused_Success);
         MCS.Sensors_Variable.Send (Sensors, Unused_Success);
         MCS.LAW.Run_Transaction;
         MCS.PWM_Variable.Receive (Unused_Item, Unused_Fresh);
      end loop;
      MCS.Law_Settings.Write (Laws_Off);
   end Fly;

end Law_Rig;
