--  MDCOUT task: the aircraft's output exchange (report, 4.7, table 7; MDO-1,
--  D-1, D-14). Released at minor frame 1.
--
--  Consumes AD_variable, produces downlink_variable and TELOUT_variable. A
--  frame with nothing new passes on the sensor data before.
--  Adds the node's own bits to the error/status word (TST-4), and on the way
--  down a piece of the error log (SAF-7).

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Errors;     use URV.Errors;
with URV.Log_Pieces; use URV.Log_Pieces;

generic
   with procedure Receive_AD (Image : out AD_Image; Fresh : out Boolean);
   with procedure Send_Downlink
     (Item : Downlink_Buffer; Success : out Boolean);
   with procedure Send_TELOUT (Item : Downlink_Buffer; Success : out Boolean);
   with procedure Read_Status (Bits : out Word);
   with procedure Next_Piece (Item : out Piece);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.MDCOUT_Task with SPARK_Mode is

   procedure Run_Transaction;

end URV.MDCOUT_Task;
