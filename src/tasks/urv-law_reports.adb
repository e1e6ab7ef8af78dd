--  SPDX-License-Identifier: Apache-2.0

with URVOS;              use URVOS;
with URV.Configurations; use URV.Configurations;
with URV.Errors;         use URV.Errors;

package body URV.LAW_Reports with SPARK_Mode is

   procedure Report_Changes (Before, After : State)
   with Global => (In_Out => Errors);

   procedure Report_Changes (Before, After : State) is
   begin
      if After.Link /= Before.Link and then Before.Link /= Waiting then
         Errors.Report
           (Link_Loss_State, Word (Link_State'Pos (After.Link)));
      end if;
      for Sensor in Sensor_Item loop
         if Before.Is_Valid (Sensor) and then not After.Is_Valid (Sensor) then
            Errors.Report
              (Sensor_Not_Valid, Word (Sensor_Item'Pos (Sensor) + 1));
         end if;
      end loop;
      for Item in Surface loop
         if After.Failed (Item) and then not Before.Failed (Item) then
            Errors.Report
              (Surface_Failed,
               Word (Sensor_Item'Pos (Sensor_Of (Item)) + 1));
         end if;
      end loop;
      if After.Engine_Failed and then not Before.Engine_Failed then
         Errors.Report (Surface_Failed, Word (Sensor_Item'Pos (RPM) + 1));
      end if;
   end Report_Changes;

   procedure Report
     (Before : State;
      After  : State;
      Usual  : Settings;
      Got    : Inputs;
      Result : Decision;
      Cards  : Test_Runs.Run)
   is
   begin
      if Result.Reply in Refused then
         Errors.Report
           (Configuration_Refused, Word (Answer'Pos (Result.Reply)));
      end if;
      if Result.Card_Reply in Test_Runs.Refused then
         Errors.Report
           (Card_Refused, Word (Test_Runs.Answer'Pos (Result.Card_Reply)));
      end if;
      if Result.Has_Ended then
         Errors.Report
           (Card_Ended,
            Word (Cards.Last_Run) * 16 + Test_Runs.Verdict'Pos (Cards.Reason));
      end if;
      if Usual.On and then not Got.Has_Sensors then
         Errors.Report (No_Image, No_Image_For_Laws);
      end if;
      if Usual.On and then not Got.Has_Commands then
         Errors.Report (No_Commands, 0);
      end if;
      Report_Changes (Before, After);
   end Report;

end URV.LAW_Reports;
