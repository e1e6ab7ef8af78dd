--  The ground's node in virtual time: whoever drives it tells it when the
--  clock ticks (KRN-1 to KRN-4, KRN-6).

package GSC.Virtual_Time with SPARK_Mode is

   --  The node starts. Its tasks begin with the next major frame; after a
   --  failed self-test there are none.
   procedure Start (Condition : Start_Condition; Now : Clock_Tick);

   --  The clock has ticked.
   procedure Clock_Interrupt (Now : Clock_Tick);

   --  How often a task has overrun.
   function Overruns return Count;

end GSC.Virtual_Time;
