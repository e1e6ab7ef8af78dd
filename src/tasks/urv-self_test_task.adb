with URVOS.ROM_Checks;

package body URV.Self_Test_Task
  with
    SPARK_Mode,
    Refined_State => (Progress => State)
is

   package Checks is new URVOS.ROM_Checks (Last);
   use Checks;

   State : Check := New_Check;

   procedure Initialise is
   begin
      State := New_Check;
   end Initialise;

   procedure Run_Transaction is
      Data    : Byte;
      Outcome : Outcome_Kind;
   begin
      for Number in 1 .. Bytes_Per_Frame loop
         Read_ROM (State.Position, Data);
         Take_Byte (State, Data, Outcome);

         case Outcome is
            when Under_Way =>
               null;
            when Found_Good =>
               Write_Result (State.Good_Passes, State.Bad_Passes);
            when Found_Bad =>
               Write_Result (State.Good_Passes, State.Bad_Passes);
               Report_Failure
                 (Word (Count'Min (State.Bad_Passes, 16#FFFF#)));
         end case;
      end loop;
   end Run_Transaction;

end URV.Self_Test_Task;
