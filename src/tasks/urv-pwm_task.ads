--  PWM task: gives the servos the pilot's commands (report, 4.8, table 8;
--  PWM-1). Released at minor frame 2.
--
--  Consumes PWM_variable, produces the data area of the PWM board. When
--  nothing new has come, or commands that are marked as old, it leaves the
--  board alone (SAF-2, SAF-3, D-14). Whoever marked them has reported why.

with Devices.PWM_Board; use Devices.PWM_Board;
with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Errors;        use URV.Errors;

generic
   with procedure Receive_PWM (Item : out Uplink_Buffer; Fresh : out Boolean);
   with procedure Write_Board (Area : Data_Area);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.PWM_Task with SPARK_Mode is

   procedure Run_Transaction;

end URV.PWM_Task;
