--  TELIN task: takes what the telemetry board received (report, 4.4, table 4;
--  TIN-1, D-14). Released at minor frame 0.
--
--  Consumes the board's receive buffers, produces TELIN_variable. A frame
--  with nothing new passes on the message before, marked as old (SAF-5).
--  Nothing is sent until the board has received its first message, nor
--  after a restart until a message has come: the one before the restart is
--  lost, and what stands for it would reach the servos.

with Telemetry;  use Telemetry;
with URVOS;      use URVOS;
with URV.Errors; use URV.Errors;

generic
   type Message is private;
   Neutral : Message;
   with function As_Old (Item : Message) return Message;
   with function Decode (Data : Block_Data) return Message;
   with procedure Take_Block
     (Data : out Block_Data; Fresh : out Boolean; Ever_Received : out Boolean);
   with procedure Send_TELIN (Item : Message; Success : out Boolean);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.TELIN_Task
  with
    SPARK_Mode,
    Abstract_State => Previous,
    Initializes    => Previous
is

   procedure Initialise;

   procedure Run_Transaction;

end URV.TELIN_Task;
