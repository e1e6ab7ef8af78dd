--  GDCIN task: the ground's input exchange (report, 5.5, table 9; GDI-1,
--  D-14). Released at minor frame 1.
--
--  Consumes TELIN_variable, produces downlink_variable. A frame with
--  nothing new passes on the sensor data before.

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Errors;     use URV.Errors;
with URV.Log_Pieces; use URV.Log_Pieces;

generic
   with procedure Receive_TELIN
     (Item : out Downlink_Buffer; Fresh : out Boolean);
   with procedure Send_Downlink
     (Item : Downlink_Buffer; Success : out Boolean);
   with procedure Take_Piece (Item : Piece);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.GDCIN_Task with SPARK_Mode is

   procedure Run_Transaction;

end URV.GDCIN_Task;
