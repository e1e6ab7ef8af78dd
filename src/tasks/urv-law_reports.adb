--  SPDX-License-Identifier: Apache-2.0

with URVOS;               use URVOS;
with URV.Buffers;         use URV.Buffers;
with URV.Configurations;  use URV.Configurations;
with URV.Errors;          use URV.Errors;
with URV.Link_Loss;       use URV.Link_Loss;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;
with URV.Test_Runs;

package body URV.LAW_Reports with SPARK_Mode is

   procedure Report_Laws (Before, After : Memory)
   with Global => (In_Out => Errors);

   procedure Report_Surfaces (Before, After : Monitor)
   with Global => (In_Out => Errors);

   procedure Report_Laws (Before, After : Memory) is
   begin
      if After.Link.State /= Before.Link.State
        and then Before.Link.State /= Waiting
      then
         Errors.Report
           (Link_Loss_State, Word (Link_State'Pos (After.Link.State)));
      end if;
      for Sensor in Sensor_Item loop
         if Before.Checks (Sensor).Is_Valid
           and then not After.Checks (Sensor).Is_Valid
         then
            Errors.Report
              (Sensor_Not_Valid, Word (Sensor_Item'Pos (Sensor) + 1));
         end if;
      end loop;
   end Report_Laws;

   procedure Report_Surfaces (Before, After : Monitor) is
   begin
      for Item in Surface loop
         if After.Failed (Item) and then not Before.Failed (Item) then
            Errors.Report
              (Surface_Failed,
               Word (Sensor_Item'Pos (Sensor_Of (Item)) + 1));
         end if;
      end loop;
      if After.Engine.Failed and then not Before.Engine.Failed then
         Errors.Report (Surface_Failed, Word (Sensor_Item'Pos (RPM) + 1));
      end if;
   end Report_Surfaces;

   procedure Report
     (Before : Kept; Usual : Settings; Got : Inputs; Result : Decision)
   is
      Reply      : constant Answer := Answer_Of (Before, Usual, Got);
      Card_Reply : constant Test_Runs.Answer :=
        Card_Answer_Of (Before, Usual, Got);
   begin
      if Reply in Refused then
         Errors.Report (Configuration_Refused, Word (Answer'Pos (Reply)));
      end if;
      if Card_Reply in Test_Runs.Refused then
         Errors.Report
           (Card_Refused, Word (Test_Runs.Answer'Pos (Card_Reply)));
      end if;
      if Result.Has_Ended then
         Errors.Report
           (Card_Ended,
            Word (Result.Cards.Run.Last_Run) * 16
            + Test_Runs.Verdict'Pos (Result.Cards.Run.Reason));
      end if;
      if Usual.On and then not Got.Has_Sensors then
         Errors.Report (No_Image, No_Image_For_Laws);
      end if;
      if Usual.On and then not Got.Has_Commands then
         Errors.Report (No_Commands, 0);
      end if;
      Report_Laws (Before.Flown, Result.Flown.After);
      Report_Surfaces (Before.Watched, Result.Surfaces.Watched);
   end Report;

end URV.LAW_Reports;
