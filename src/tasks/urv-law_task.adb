--  SPDX-License-Identifier: Apache-2.0

with URV.Card_Status;
with URV.Errors;    use URV.Errors;
with URV.LAW_Reports;
with URV.LAW_Steps; use URV.LAW_Steps;
with URV.Laws;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.Recorder_Rows; use URV.Recorder_Rows;
with URV.Test_Runs;

package body URV.LAW_Task with SPARK_Mode is

   package Reports is new URV.LAW_Reports (Errors);

   procedure Decide_And_Report
     (Usual : Laws.Settings; Got : Inputs; Result : out Decision)
   with
     Global => (In_Out => (Law_Memory, Law_Record, Card_Shown, Errors));

   procedure Decide_And_Report
     (Usual : Laws.Settings; Got : Inputs; Result : out Decision)
   is
      Link     : Link_State    := Law_Memory.Link;
      Recorded : Recorded_Laws := Law_Record.Contents;
      Before   : constant Reports.State :=
        Reports.State_Of (Link, Recorded.Laws);
      Cards    : Test_Runs.Run;
   begin
      Law_Memory.Decide (Usual, Got, Result);
      Link := Law_Memory.Link;
      Recorded := Law_Memory.Recorded;
      Cards := Law_Memory.Cards;
      Law_Record.Write (Recorded);
      Card_Shown.Write (Card_Status.Card_Word (Cards));
      Reports.Report
        (Before, Reports.State_Of (Link, Recorded.Laws), Usual, Got, Result,
         Cards);
   end Decide_And_Report;

   procedure Run_Transaction is
      Usual   : constant Laws.Settings := Law_Settings.Contents;
      Got     : Inputs;
      Result  : Decision;
      Success : Boolean;
   begin
      Configuration_Variable.Receive (Got.Block, Got.Has_Block);
      Sensors_Variable.Receive (Got.Sensors, Got.Has_Sensors);
      Commands_Variable.Receive (Got.Commands, Got.Has_Commands);

      --  Nothing to report: Decide would give the same.
      if Is_Passive (Usual, Got) then
         Result := Passed_On (Got);
      else
         Decide_And_Report (Usual, Got, Result);
      end if;
      Surface_Health.Write (Result.Reported);
      Test_Added.Write (Result.Added);

      if Result.Flown.Is_Sent then
         PWM_Variable.Send (Result.Flown.Message, Success);
         if not Success then
            Errors.Report (Commands_Not_Consumed, 0);
         end if;
      end if;
   end Run_Transaction;

end URV.LAW_Task;
