--  SPDX-License-Identifier: Apache-2.0

--  The contracts of the operations here are complete: they leave no result
--  open (EVI-7). Done twice with the same inputs, an operation gives the same
--  results. GNATprove knows only the contract of a call, so a postcondition
--  with a gap would leave a theorem here unproved. A complete contract may
--  still be wrong; tests and the other theorems address that.
--
--  Functions need no such theorem: their postcondition is an expression, or an
--  equation for each part of the result. The same holds for procedures whose
--  postcondition is an equation (URVOS.Schedulers.Calls).

with Telemetry;
with Telemetry.Boards;
with Telemetry.Headers;
with Telemetry.Memory;
with Telemetry.Receivers;
with URVOS;
with URVOS.Error_Logs;
with URVOS.Frames;
with URVOS.Memories;
with URVOS.ROM_Checks;
with URVOS.Semaphores;
with URVOS.Start_Orders;
with URVOS.Waits;
with URV.AD_Scans;
with URV.Buffers;
with URV.Log_Pieces;
with URV.Mailboxes;

package Theorems.Results with SPARK_Mode, Ghost is

   use Telemetry;
   use Telemetry.Boards;
   use Telemetry.Headers;
   use Telemetry.Memory;
   use Telemetry.Receivers;
   use URVOS;
   use URVOS.Frames;
   use URVOS.Semaphores;
   use URVOS.Start_Orders;
   use URVOS.Waits;
   use URV.AD_Scans;
   use URV.Buffers;
   use URV.Mailboxes.For_Stick_Words.Boxes;

   --  The kernel

   type Kind is (This, That);

   package Logs is new URVOS.Error_Logs (Kind);
   use Logs;

   procedure Of_Add
     (Log       : Error_Log;
      Which     : Kind;
      Now       : Clock_Tick;
      Detail    : Word;
      How_Often : Positive_Count;
      Same      : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Send
     (Box  : Mailbox;
      Item : Channel_Words;
      Same : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Look (Box : Mailbox; Same : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Look
     (State : Node_State;
      Who   : Seat;
      Same  : out Boolean)
   with
     Global => null,
     Pre    => Who <= Seat (State.Processors),
     Post   => Same;

   procedure Of_Receive (Box : Mailbox; Same : out Boolean)
   with
     Global => null,
     Post   => Same;

   package Checks is new URVOS.ROM_Checks (Last => 16#3FFF#);
   use Checks;

   procedure Of_Take_Long
     (Item : Check;
      Data : URVOS.Memories.Long;
      Same : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Try_Claim
     (Item   : Semaphore;
      Caller : Claimant;
      Same   : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Release
     (Item   : Semaphore;
      Caller : Claimant;
      Same   : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Note_Look
     (Item : Wait;
      Now  : Clock_Tick;
      Same : out Boolean)
   with
     Global => null,
     Pre    => not Is_Over (Item, Now),
     Post   => Same;

   --  The telemetry board

   procedure Of_Store_Byte
     (Item         : Receiver;
      Pair         : Buffer_Pair;
      Length       : Block_Length;
      Data         : Byte;
      Parity_Error : Boolean;
      Same         : out Boolean)
   with
     Global => null,
     Pre    => Fits (Item, Pair, Length) and then Takes_Byte (Item, Length),
     Post   => Same;

   procedure Of_Accept_Character
     (Item         : Receiver;
      Pair         : Buffer_Pair;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      Same         : out Boolean)
   with
     Global => null,
     Pre    => Fits (Item, Pair, Length),
     Post   => Same;

   procedure Of_Accept_Character
     (Item         : Board;
      Data         : Byte;
      Parity_Error : Boolean;
      Same         : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Same;

   procedure Of_Next_Character (Item : Board; Same : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Same;

   procedure Of_Elapse
     (Item : Board;
      Time : Character_Times;
      Same : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Same;

   procedure Of_Take (Item : Board; Same : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Same;

   procedure Of_Put
     (Item : Board;
      Data : Block_Data;
      Same : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Same;

   procedure Of_Clear_Transmit_Half (Item : Board; Same : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Same;

   procedure Of_Set_Round_Trip
     (Item : Board;
      Time : Round_Trip_Time;
      Same : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Same;

   procedure Of_Start (Item : Board; Same : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item),
     Post   => Same;

   --  The tasks

   procedure Of_Store
     (Item  : Scan;
      Value : Word;
      Same  : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Take
     (Item : URV.Log_Pieces.Receiver;
      What : URV.Log_Pieces.Piece;
      Same : out Boolean)
   with
     Global => null,
     Post   => Same;

end Theorems.Results;
