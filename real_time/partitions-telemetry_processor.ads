--  The processor of a telemetry board, as its own task: its DUART's
--  interrupt, its main program, its timer (report, appendix A; LNK-1).
--
--  What has arrived is told before the board is told that time has passed,
--  and a character begins when the one before it ended, not when the task
--  woke up: so a task that the machine runs late loses no character and
--  takes no lateness for silence.

with Telemetry; use Telemetry;
with URVOS;     use URVOS;

generic
   with procedure Start;
   with procedure Accept_Character
     (Elapsed      : Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      May_Speak    : out Boolean);
   with procedure Next_Character
     (Elapsed   : Character_Times;
      Send      : out Boolean;
      Data      : out Byte;
      Time_Left : out Character_Times);
package Partitions.Telemetry_Processor is

   --  Power up: the board starts, and its task with it.
   procedure Switch_On;

   --  The controller has given the board something: its main program, which
   --  looks at its flags all the time, finds it now.
   procedure Look;

end Partitions.Telemetry_Processor;
