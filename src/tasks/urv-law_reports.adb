--  SPDX-License-Identifier: Apache-2.0

with URV.Buffers;         use URV.Buffers;
with URV.Configurations;  use URV.Configurations;
with URV.Errors;          use URV.Errors;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;

package body URV.LAW_Reports with SPARK_Mode is

   --  Reports each bit, the lowest with this detail.
   procedure Report_Bits (Kind : Error_Kind; Bits : Word; First : Word)
   with Global => (In_Out => Errors);

   procedure Report_Changes (Before, After : State)
   with Global => (In_Out => Errors);

   procedure Report_Bits (Kind : Error_Kind; Bits : Word; First : Word) is
      Rest   : Word := Bits;
      Detail : Word := First;
   begin
      while Rest /= 0 loop
         pragma Loop_Variant (Decreases => Rest);
         if (Rest and 1) /= 0 then
            Errors.Report (Kind, Detail);
         end if;
         Rest := Rest / 2;
         Detail := Detail + 1;
      end loop;
   end Report_Bits;

   procedure Report_Changes (Before, After : State) is
      Failed : Word;
   begin
      if After.Link /= Before.Link and then Before.Link /= Waiting then
         Errors.Report
           (Link_Loss_State, Word (Link_State'Pos (After.Link)));
      end if;
      Report_Bits
        (Sensor_Not_Valid, After.Invalid_Low and not Before.Invalid_Low, 1);
      Report_Bits
        (Sensor_Not_Valid, After.Invalid_High and not Before.Invalid_High,
         17);
      Failed := After.Failed and not Before.Failed;
      if Failed /= 0 then
         for Item in Surface loop
            if (Failed and Bits_Of ((None with delta Item => True))) /= 0 then
               Errors.Report
                 (Surface_Failed,
                  Word (Sensor_Item'Pos (Sensor_Of (Item)) + 1));
            end if;
         end loop;
         if (Failed and Throttle_Bit) /= 0 then
            Errors.Report (Surface_Failed, Word (Sensor_Item'Pos (RPM) + 1));
         end if;
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
