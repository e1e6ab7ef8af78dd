--  The ground's node in real time, as it is proved: with the steps of the
--  partition, but for what catches their exceptions and measures them (D-9).

package Real_Time_GSC with SPARK_Mode is

   --  Power up.
   procedure Switch_On;

end Real_Time_GSC;
