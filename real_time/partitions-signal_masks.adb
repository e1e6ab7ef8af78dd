--  SPDX-License-Identifier: Apache-2.0

with Interfaces.C; use Interfaces.C;
with System;

package body Partitions.Signal_Masks is

   Set    : Signal_Set;
   Status : int;

   Enders : Signal_Set;

   function Ours return Signal_Set is (Set);

   procedure Let_End is
      Unused : int;
   begin
      Unused := Set_Mask (To_Unblock, Enders, System.Null_Address);
   end Let_End;

   procedure Block is
      Unused : int;
   begin
      Unused := Set_Mask (To_Block, Set, System.Null_Address);
   end Block;

begin
   Add (Enders, Interrupt);
   Add (Enders, Terminate_Program);
   Set := Enders;
   Add (Set, User_1);
   Add (Set, User_2);
   Status := Set_Mask (To_Block, Set, System.Null_Address);
   Status := Status + Set_Process (Timer_Slack, 1);

   --  After a failure the partition runs all the same, only less exactly.
   pragma Unreferenced (Status);
end Partitions.Signal_Masks;
