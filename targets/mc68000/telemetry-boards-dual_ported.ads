--  SPDX-License-Identifier: Apache-2.0

--  The memory that a telemetry board shares with its controller, each a
--  processor of its own (report, appendix A.2; BRD-8, D-99). image.ld has its
--  address. Each operation claims the one lock byte with TAS, in one
--  indivisible cycle of the bus, and releases it.
--
--  A claim waits for longer than the longest operation. If the byte is still
--  taken then, the other processor has failed within an operation: the
--  operation below is left out, with the results given there, and so are all
--  later ones until the byte is free. They do not wait again. The failed
--  processor releases its claim when it restarts.
--
--  Interrupts that use these operations are masked during each of them.

package Telemetry.Boards.Dual_Ported is

   --  Starts

   --  At the controller's power up: start.s has taken the memory from the
   --  board and released the lock. A controller that restarts before its clock
   --  has begun initialises again, and the board may use the memory then.
   procedure Initialise (First : Board; Time : Round_Trip_Time);

   --  The board's processor may use the memory from now on.
   procedure Make_Ready;

   --  The board's processor does not touch the memory before.
   function Is_Ready return Boolean
   with Inline;

   --  The controller has taken the memory back: the board starts again.
   function Is_Taken return Boolean
   with Inline;

   --  At each restart of a processor: releases what it had claimed. If it
   --  failed within an operation, the buffers and the state of the protocol
   --  are reset; their blocks are lost, and the counts remain.
   procedure Recover;

   --  The controller's side

   --  Without a claim there is no fresh block.
   procedure Take
     (Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean);

   --  Without a claim the block is lost, and Overwrote is True.
   procedure Put (Data : Block_Data; Overwrote : out Boolean);

   --  Without a claim these two are done with the next operation that gets
   --  one.

   procedure Clear_Transmit_Half;

   procedure Discard_Received;

   --  Without a claim: False
   function Has_Received return Boolean;

   --  Without a claim: the last one read
   function Tally return Statistics;

   --  The board's side

   procedure Start;

   --  The controller has put or cleared a block since the last Next_Character.
   --  It needs no claim.
   function Has_News return Boolean
   with Inline;

   --  Without a claim the character is lost. Later the board finds the message
   --  bad.
   procedure Accept_Character
     (Elapsed      : Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      May_Speak    : out Boolean)
   with Inline;

   --  Without a claim the board has nothing to send, and looks again after a
   --  character time.
   procedure Next_Character
     (Elapsed   : Character_Times;
      Send      : out Boolean;
      Data      : out Byte;
      Time_Left : out Character_Times)
   with Inline;

end Telemetry.Boards.Dual_Ported;
