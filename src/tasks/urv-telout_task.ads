--  TELOUT task: gives the telemetry board a block to transmit (report, 4.5,
--  table 5; TOU-1). Released at minor frame 2.
--
--  Consumes TELOUT_variable, produces the board's transmit buffers. When no
--  buffer is available the newest data overwrites; when nothing new has
--  come nothing is written.

with Telemetry;  use Telemetry;
with URVOS;      use URVOS;
with URV.Errors; use URV.Errors;

generic
   type Message is private;
   with function Encode (Item : Message) return Block_Data;
   with procedure Receive_TELOUT (Item : out Message; Fresh : out Boolean);
   with procedure Put_Block (Data : Block_Data; Overwrote : out Boolean);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.TELOUT_Task with SPARK_Mode is

   procedure Run_Transaction;

end URV.TELOUT_Task;
