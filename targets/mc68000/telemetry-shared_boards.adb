--  SPDX-License-Identifier: Apache-2.0

--  The controller's operations on a telemetry board that is a processor of its
--  own (BRD-8). The protected action only masks the controller's interrupts.
--  The board itself is in the dual-ported memory; This is its first state.

with Telemetry.Boards.Dual_Ported;

package body Telemetry.Shared_Boards is

   protected body Shared_Board is

      procedure Take
        (Data          : out Block_Data;
         Fresh         : out Boolean;
         Ever_Received : out Boolean)
      is
      begin
         Dual_Ported.Take (Data, Fresh, Ever_Received);
      end Take;

      procedure Put (Data : Block_Data; Overwrote : out Boolean) is
      begin
         Dual_Ported.Put (Data, Overwrote);
      end Put;

      procedure Clear_Transmit_Half is
      begin
         Dual_Ported.Clear_Transmit_Half;
      end Clear_Transmit_Half;

      procedure Discard_Received is
      begin
         Dual_Ported.Discard_Received;
      end Discard_Received;

      procedure Set_Round_Trip (Time : Round_Trip_Time) is
      begin
         Dual_Ported.Initialise (This, Time);
      end Set_Round_Trip;

      procedure Start is
      begin
         Dual_Ported.Start;
         Dual_Ported.Make_Ready;
      end Start;

      procedure Accept_Character
        (Elapsed      : Character_Times;
         Data         : Byte;
         Parity_Error : Boolean;
         May_Speak    : out Boolean)
      is
      begin
         Dual_Ported.Accept_Character
           (Elapsed, Data, Parity_Error, May_Speak);
      end Accept_Character;

      procedure Next_Character
        (Elapsed   : Character_Times;
         Send      : out Boolean;
         Data      : out Byte;
         Time_Left : out Character_Times)
      is
      begin
         Dual_Ported.Next_Character (Elapsed, Send, Data, Time_Left);
      end Next_Character;

      function Has_Received return Boolean is (Dual_Ported.Has_Received);

      function Tally return Statistics is (Dual_Ported.Tally);

   end Shared_Board;

end Telemetry.Shared_Boards;
