--  The analog-to-digital interrupt handler (report, 4.2, table 2; ADI-1).
--
--  Produces ADINT_variable. Its locals are Channel and the data area, which
--  the AD task resets when it begins a scan.

with Devices.AD_Board; use Devices.AD_Board;
with URVOS;            use URVOS;
with URV.AD_Scans;     use URV.AD_Scans;
with URV.Buffers;      use URV.Buffers;
with URV.Errors;       use URV.Errors;

generic
   with procedure Read_Board (Data : out Word);
   with procedure Start_Channel (Which : Channel_Number);
   with procedure Send_ADINT (Words : Channel_Words; Success : out Boolean);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.ADINT_Handler
  with
    SPARK_Mode,
    Abstract_State =>
      (Current_Scan with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Current_Scan
is

   --  Begins a scan with channel 0. Reached is how many channels the scan
   --  before had converted.
   procedure Begin_Scan (Reached : out Channel_Count);

   --  The board has converted a channel.
   procedure Handle_Interrupt;

end URV.ADINT_Handler;
