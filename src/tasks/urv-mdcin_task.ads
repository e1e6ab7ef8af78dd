--  MDCIN task: the aircraft's input exchange (report, 4.6, table 6; MDI-1,
--  D-11, D-14). Released at minor frame 1.
--
--  Consumes TELIN_variable, produces uplink_variable and PWM_variable. A
--  frame with nothing new passes on the commands before.

with URVOS;       use URVOS;
with URV.Buffers; use URV.Buffers;
with URV.Errors;  use URV.Errors;

generic
   with procedure Receive_TELIN
     (Item : out Uplink_Buffer; Fresh : out Boolean);
   with procedure Send_Uplink (Item : Uplink_Buffer; Success : out Boolean);
   with procedure Send_PWM (Item : Uplink_Buffer; Success : out Boolean);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.MDCIN_Task with SPARK_Mode is

   procedure Run_Transaction;

end URV.MDCIN_Task;
