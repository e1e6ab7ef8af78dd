--  SPDX-License-Identifier: Apache-2.0

--  A telemetry board, shared by its controller, its interrupt handler, its
--  main program and its timer (report, appendix A; LNK-1, D-24).
--
--  Each operation of Telemetry.Boards is one protected action here. Each call
--  from the board's own side gives the time since the call before it.

with Telemetry.Boards;  use Telemetry.Boards;
with Telemetry.Headers; use Telemetry.Headers;

package Telemetry.Shared_Boards with SPARK_Mode is

   subtype Sound_Board is Board
   with Predicate => Is_Sound (Sound_Board);

   protected type Shared_Board
     (Role            : Station;
      Transmit_Length : Block_Length;
      Receive_Length  : Block_Length)
   is

      --  The controller's side; see Telemetry.Boards

      procedure Take
        (Data          : out Block_Data;
         Fresh         : out Boolean;
         Ever_Received : out Boolean);

      procedure Put (Data : Block_Data; Overwrote : out Boolean);

      procedure Clear_Transmit_Half;

      --  The controller will ignore all blocks received up to now (SAF-4).
      procedure Discard_Received;

      --  The board's side

      --  Call it before the board starts; see Telemetry.Boards.
      procedure Set_Round_Trip (Time : Round_Trip_Time);

      procedure Start;

      --  May_Speak is True if Next_Character may now give a character. If it
      --  is False, the board waits for more characters or for its time-out.
      procedure Accept_Character
        (Elapsed      : Character_Times;
         Data         : Byte;
         Parity_Error : Boolean;
         May_Speak    : out Boolean);

      --  Time_Left is the longest time that the board waits without an event.
      procedure Next_Character
        (Elapsed   : Character_Times;
         Send      : out Boolean;
         Data      : out Byte;
         Time_Left : out Character_Times);

      --  A block has been received and waits to be taken.
      function Has_Received return Boolean;

      --  For monitors of the link.
      function Tally return Statistics;

   private
      This : Sound_Board :=
        New_Board (Role, Transmit_Length, Receive_Length);
   end Shared_Board;

end Telemetry.Shared_Boards;
