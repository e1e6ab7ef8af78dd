--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Memory;

package body Telemetry.Shared_Boards with SPARK_Mode is

   protected body Shared_Board is

      procedure Take
        (Data          : out Block_Data;
         Fresh         : out Boolean;
         Ever_Received : out Boolean)
      is
      begin
         Boards.Take (This, Data, Fresh, Ever_Received);
      end Take;

      procedure Put (Data : Block_Data; Overwrote : out Boolean) is
      begin
         Boards.Put (This, Data, Overwrote);
      end Put;

      procedure Clear_Transmit_Half is
      begin
         Boards.Clear_Transmit_Half (This);
      end Clear_Transmit_Half;

      procedure Discard_Received is
         Unused_Data          : Block_Data;
         Unused_Fresh         : Boolean;
         Unused_Ever_Received : Boolean;
      begin
         Boards.Take
           (This, Unused_Data, Unused_Fresh, Unused_Ever_Received);
      end Discard_Received;

      procedure Set_Round_Trip (Time : Round_Trip_Time) is
      begin
         Boards.Set_Round_Trip (This, Time);
      end Set_Round_Trip;

      procedure Start is
      begin
         Boards.Start (This);
      end Start;

      procedure Accept_Character
        (Elapsed      : Character_Times;
         Data         : Byte;
         Parity_Error : Boolean;
         May_Speak    : out Boolean)
      is
      begin
         Boards.Elapse (This, Elapsed);
         Boards.Accept_Character (This, Data, Parity_Error);
         May_Speak := Boards.May_Speak (This);
      end Accept_Character;

      procedure Next_Character
        (Elapsed   : Character_Times;
         Send      : out Boolean;
         Data      : out Byte;
         Time_Left : out Character_Times)
      is
      begin
         Boards.Elapse (This, Elapsed);
         Boards.Next_Character (This, Send, Data);
         Time_Left := Boards.Time_Left (This);
      end Next_Character;

      function Has_Received return Boolean is
        (Memory.Any_Full (Receive_Pair (This)));

      function Tally return Statistics is (Boards.Tally (This));

   end Shared_Board;

end Telemetry.Shared_Boards;
