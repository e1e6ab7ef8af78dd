--  A telemetry board between its controller, its interrupt handler, its main
--  program and its timer (report, appendix A; LNK-1, D-24).
--
--  Each operation of Telemetry.Boards is one protected action here. The
--  board's own side tells how much time has passed since it last did.

with Telemetry.Boards;  use Telemetry.Boards;
with Telemetry.Headers; use Telemetry.Headers;

generic
   Role            : Station;
   Transmit_Length : Block_Length;
   Receive_Length  : Block_Length;
package Telemetry.Shared_Boards
  with
    SPARK_Mode,
    Abstract_State =>
      (Shared_Board with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Shared_Board
is

   --  The controller's side: see Telemetry.Boards.

   procedure Take
     (Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean)
   with Global => (In_Out => Shared_Board);

   procedure Put (Data : Block_Data; Overwrote : out Boolean)
   with Global => (In_Out => Shared_Board);

   procedure Clear_Transmit_Half
   with Global => (In_Out => Shared_Board);

   --  The board's side.

   procedure Start
   with Global => (In_Out => Shared_Board);

   --  May_Speak tells whether Next_Character may now give a character; if
   --  not, the board waits for more characters or for its time-out.
   procedure Accept_Character
     (Elapsed      : Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      May_Speak    : out Boolean)
   with Global => (In_Out => Shared_Board);

   --  Time_Left is how long the board will wait if nothing happens.
   procedure Next_Character
     (Elapsed   : Character_Times;
      Send      : out Boolean;
      Data      : out Byte;
      Time_Left : out Character_Times)
   with Global => (In_Out => Shared_Board);

   --  For whoever watches over the link.
   procedure Inspect (Tally : out Statistics)
   with Global => (Input => Shared_Board);

end Telemetry.Shared_Boards;
