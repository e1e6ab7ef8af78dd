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
         Boards.Take (Item, Data, Fresh, Ever_Received);
      end Take;

      procedure Put (Data : Block_Data; Overwrote : out Boolean) is
      begin
         Boards.Put (Item, Data, Overwrote);
      end Put;

      procedure Clear_Transmit_Half is
      begin
         Boards.Clear_Transmit_Half (Item);
      end Clear_Transmit_Half;

      procedure Discard_Received is
         Unused_Data          : Block_Data;
         Unused_Fresh         : Boolean;
         Unused_Ever_Received : Boolean;
      begin
         Boards.Take
           (Item, Unused_Data, Unused_Fresh, Unused_Ever_Received);
      end Discard_Received;

      procedure Start is
      begin
         Boards.Start (Item);
      end Start;

      procedure Accept_Character
        (Elapsed      : Character_Times;
         Data         : Byte;
         Parity_Error : Boolean;
         May_Speak    : out Boolean)
      is
      begin
         Boards.Elapse (Item, Elapsed);
         Boards.Accept_Character (Item, Data, Parity_Error);
         May_Speak := Boards.May_Speak (Item);
      end Accept_Character;

      procedure Next_Character
        (Elapsed   : Character_Times;
         Send      : out Boolean;
         Data      : out Byte;
         Time_Left : out Character_Times)
      is
      begin
         Boards.Elapse (Item, Elapsed);
         Boards.Next_Character (Item, Send, Data);
         Time_Left := Boards.Time_Left (Item);
      end Next_Character;

      function Has_Received return Boolean is
        (Memory.Any_Full (Receive_Pair (Item)));

      function Tally return Statistics is (Boards.Tally (Item));

   end Shared_Board;

end Telemetry.Shared_Boards;
