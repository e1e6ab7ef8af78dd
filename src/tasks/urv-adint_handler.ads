--  The analog-to-digital interrupt handler (report, 4.2, table 2; ADI-1).
--
--  Produces ADINT_variable. Its locals are Channel and the data area, which
--  the AD task resets when it begins a scan.

with Devices.AD_Board; use Devices.AD_Board;
with URVOS;            use URVOS;
with URV.Buffers;      use URV.Buffers;
with URV.Errors;       use URV.Errors;

generic
   with procedure Read_Board (Data : out Word);
   with procedure Start_Channel (Which : Channel_Number);
   with procedure Send_ADINT (Words : Channel_Words; Success : out Boolean);
   with procedure Report (Error : Error_Kind);
package URV.ADINT_Handler
  with
    SPARK_Mode,
    Abstract_State =>
      (Current_Scan with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Current_Scan
is

   --  Begins a scan with channel 0.
   procedure Begin_Scan;

   --  The board has converted a channel.
   procedure Handle_Interrupt;

end URV.ADINT_Handler;
