--  The aircraft's node in virtual time: whoever drives it tells it when the
--  clock ticks (KRN-1 to KRN-6, EXT-4, D-23).

package MCS.Virtual_Time with SPARK_Mode is

   --  The node starts. Its tasks begin with the next major frame; after a
   --  failed self-test there are none.
   procedure Start
     (Condition  : Start_Condition;
      Now        : Clock_Tick;
      Processors : Processor_Number := 1);

   --  The clock has ticked, for every processor.
   procedure Clock_Interrupt (Now : Clock_Tick);

   --  How often a task has overrun, on any processor.
   function Overruns return Count;

end MCS.Virtual_Time;
