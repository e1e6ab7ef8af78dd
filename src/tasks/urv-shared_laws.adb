--  SPDX-License-Identifier: Apache-2.0

package body URV.Shared_Laws with SPARK_Mode is

   protected body Memory_Store is

      procedure Decide
        (Usual  : URV.Laws.Settings;
         Got    : URV.LAW_Steps.Inputs;
         Result : out URV.LAW_Steps.Decision) is
      begin
         LAW_Steps.Decide (Kept, Usual, Got, Result);
      end Decide;

      procedure Write (Item : URV.LAW_Steps.Kept) is
      begin
         Kept := Item;
      end Write;

      function Contents return URV.LAW_Steps.Kept is (Kept);

      function Link return URV.Link_Loss.Link_State is (Kept.Flown.Link.State);

      function Cards return URV.Test_Runs.Run is (Kept.Cards.Run);

      function Recorded return Recorded_Laws is (Recorded_Of (Kept));

   end Memory_Store;

end URV.Shared_Laws;
