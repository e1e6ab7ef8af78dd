--  SPDX-License-Identifier: Apache-2.0

--  The analog-to-digital interrupt handler (report, 4.2, table 2; ADI-1).
--
--  Produces ADINT_variable. Its locals are Channel and the data area, which
--  the AD task resets when it begins a scan: URV.AD_Boards keeps them.

with URVOS;             use URVOS;
with URVOS.Shared_Mailboxes;
with URV.AD_Boards;
with URV.AD_Scans;      use URV.AD_Scans;
with URV.Buffers;       use URV.Buffers;
with URV.Shared_Errors; use URV.Shared_Errors;

generic
   with package Words is
     new URVOS.Shared_Mailboxes (Message => Channel_Words, others => <>);
   AD_Board       : in out URV.AD_Boards.Board;
   ADINT_Variable : in out Words.Variable;
   Errors         : in out Shared_Log;
package URV.ADINT_Handler with SPARK_Mode is

   --  Begins a scan with channel 0. Reached is the number of channels that the
   --  last scan converted.
   procedure Begin_Scan (Reached : out Channel_Count)
   with Global => (In_Out => AD_Board);

   --  The board has converted a channel.
   procedure Handle_Interrupt
   with Global => (In_Out => (AD_Board, ADINT_Variable, Errors));

   --  The same on a machine whose own interrupt ends the conversion with a
   --  Value: it passes the value to AD_Board, and calls this for a successor
   --  that is not a channel.
   procedure Handle_End (Next : Successor; Value : Word)
   with
     Global => (Input => AD_Board, In_Out => (ADINT_Variable, Errors)),
     Pre    => Next not in Next_Channel;

end URV.ADINT_Handler;
