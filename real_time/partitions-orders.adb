--  SPDX-License-Identifier: Apache-2.0

with GSC;
with Host;               use Host;
with Host.Ground_Orders; use Host.Ground_Orders;
with Partitions.Clocks;

package body Partitions.Orders is

   --  Used by the converter only.
   Script  : Host.Ground_Orders.Script;
   Free_At : Microseconds := 0;

   Number_Sent : Count := 0 with Atomic;

   --  From the console's port to the converter.
   protected Waiting is
      procedure Put (Block : Uplink_Buffer; Is_Taken : out Boolean);
      procedure Take (Block : out Uplink_Buffer; Found : out Boolean);
   private
      Held  : Uplink_Buffer := Neutral_Uplink;
      Is_In : Boolean := False;
   end Waiting;

   protected body Waiting is

      procedure Put (Block : Uplink_Buffer; Is_Taken : out Boolean) is
      begin
         Is_Taken := not Is_In;
         if Is_Taken then
            Held := Block;
            Is_In := True;
         end if;
      end Put;

      procedure Take (Block : out Uplink_Buffer; Found : out Boolean) is
      begin
         Block := Held;
         Found := Is_In;
         Is_In := False;
      end Take;

   end Waiting;

   procedure Load (File : String) is
   begin
      Load (Script, File);
   end Load;

   procedure Give (Block : Uplink_Buffer; Is_Taken : out Boolean) is
   begin
      Waiting.Put (Block, Is_Taken);
   end Give;

   procedure Send_Due is
      Now     : constant Microseconds := Clocks.Elapsed;
      Block   : Uplink_Buffer;
      Found   : Boolean;
      Success : Boolean;
   begin
      if Now < Free_At then
         return;
      end if;
      Waiting.Take (Block, Found);
      if not Found and then Next_Time (Script) <= Now then
         Advance (Script, Block);
         Found := True;
      end if;
      if Found then
         Free_At := Now + Least_Between;
         Number_Sent := Incremented (Number_Sent);
         GSC.Console_Orders.Send (Block, Success);
         pragma Unreferenced (Success);
      end if;
   end Send_Due;

   function Sent return Count is (Number_Sent);

end Partitions.Orders;
