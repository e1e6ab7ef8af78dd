--  The aircraft's multiprocessor control system in its partition.

with MCS;
with Partitions.Aircraft;
with Partitions.Converter;
with Partitions.Rows;
with Partitions.Signals;
with Partitions.Telemetry_Processor;

package Partitions.MCS_Node is

   package Telemetry_Processor is new Partitions.Telemetry_Processor
     (Start            => MCS.Telemetry_Board.Start,
      Accept_Character => MCS.Telemetry_Board.Accept_Character,
      Next_Character   => MCS.Telemetry_Board.Next_Character);

   package Converter is new Partitions.Converter
     (Sample               => Aircraft.Sample,
      Take_Start           => MCS.AD_Board.Take_Start,
      Finish               => MCS.AD_Board.Finish,
      Interrupt_Controller => MCS.AD_Interrupt);

   procedure Restart_Processor is null;

   package Signals is new Partitions.Signals
     (Switch_Off                => Rows.Queue.Finish,
      Raise_Processor_Exception => Restart_Processor);

   --  Power up of every board.
   procedure Switch_On;

end Partitions.MCS_Node;
