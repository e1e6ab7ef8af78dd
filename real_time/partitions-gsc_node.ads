--  The ground station core in its partition.

with GSC;
with Partitions.Console;
with Partitions.Converter;
with Partitions.Rows;
with Partitions.Signals;
with Partitions.Telemetry_Processor;

package Partitions.GSC_Node is

   package Telemetry_Processor is new Partitions.Telemetry_Processor
     (Start            => GSC.Telemetry_Board.Start,
      Accept_Character => GSC.Telemetry_Board.Accept_Character,
      Next_Character   => GSC.Telemetry_Board.Next_Character);

   package Converter is new Partitions.Converter
     (Sample               => Console.Sample,
      Take_Start           => GSC.AD_Board.Take_Start,
      Finish               => GSC.AD_Board.Finish,
      Interrupt_Controller => GSC.AD_Interrupt);

   procedure Restart_Processor is null;

   package Signals is new Partitions.Signals
     (Switch_Off                => Rows.Queue.Finish,
      Raise_Processor_Exception => Restart_Processor);

   --  Power up of every board.
   procedure Switch_On;

end Partitions.GSC_Node;
