--  A telemetry board whose operations exclude each other: what
--  Telemetry.Shared_Boards consists of (report, appendix A; LNK-1, D-24).
--
--  It is a type so that it is proved once, not for each node.

with Telemetry.Boards;  use Telemetry.Boards;
with Telemetry.Headers; use Telemetry.Headers;

private package Telemetry.Guarded_Boards with SPARK_Mode is

   subtype Sound_Board is Board
   with Predicate => Is_Sound (Sound_Board);

   protected type Guarded_Board
     (Role            : Station;
      Transmit_Length : Block_Length;
      Receive_Length  : Block_Length)
   is

      procedure Take
        (Data          : out Block_Data;
         Fresh         : out Boolean;
         Ever_Received : out Boolean);

      procedure Put (Data : Block_Data; Overwrote : out Boolean);

      procedure Clear_Transmit_Half;

      procedure Start;

      procedure Accept_Character
        (Elapsed      : Character_Times;
         Data         : Byte;
         Parity_Error : Boolean;
         May_Speak    : out Boolean);

      procedure Next_Character
        (Elapsed   : Character_Times;
         Send      : out Boolean;
         Data      : out Byte;
         Time_Left : out Character_Times);

      function Tally return Statistics;

   private
      Item : Sound_Board (Role, Transmit_Length, Receive_Length);
   end Guarded_Board;

end Telemetry.Guarded_Boards;
