--  SPDX-License-Identifier: Apache-2.0

with URV.Buffers;     use URV.Buffers;
with URV.CORE_Layout; use URV.CORE_Layout;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Errors;      use URV.Errors;

package body URV.Self_Test_Task with SPARK_Mode is

   use Checks;

   --  Records the end of a pass: the numbers of passes since the start that
   --  found the image right and wrong.
   procedure Write_Result (Good_Passes, Bad_Passes : Count);

   procedure Write_Result (Good_Passes, Bad_Passes : Count) is
   begin
      CORE_Memory.Write_Status
        ((ROM_Passes   => To_Word (Good_Passes),
          ROM_Failures => To_Word (Bad_Passes)));
      if Bad_Passes > 0 then
         Node_Status.Add (ROM_Differs);
      end if;
   end Write_Result;

   procedure Initialise is
   begin
      Progress.Write (New_Check);
   end Initialise;

   procedure Run_Transaction is
      State   : Check := Progress.Contents;
      Data    : Long;
      Outcome : Outcome_Kind;
   begin
      for Number in 1 .. Longs_Per_Frame loop
         Read_ROM (Byte_Of (State.Position), Data);
         Take_Long (State, Data, Outcome);

         case Outcome is
            when Under_Way =>
               null;
            when Found_Good =>
               Write_Result (State.Good_Passes, State.Bad_Passes);
            when Found_Bad =>
               Write_Result (State.Good_Passes, State.Bad_Passes);
               Errors.Report (ROM_Check_Failed, To_Word (State.Bad_Passes));
         end case;
      end loop;
      Progress.Write (State);
   end Run_Transaction;

end URV.Self_Test_Task;
