--  SPDX-License-Identifier: Apache-2.0

--  LAW's memory from frame to frame (the laws' memory, the ground's settings,
--  the monitor of surfaces), the words of it that the flight recorder records,
--  and the laws' settings (EXT-2, EXT-3, EXT-5, EXT-6, FTI-9). A warm start
--  keeps them.

pragma SPARK_Mode;

with System;
with URVOS.Shared_Data;
with URV.Card_Status;
with URV.LAW_Steps;
with URV.Laws;
with URV.Law_Status;    use URV.Law_Status;
with URV.Link_Loss;
with URV.Recorder_Rows; use URV.Recorder_Rows;
with URV.Surface_Monitor;
with URV.Test_Runs;

package URV.Shared_Laws is

   function Words_Of (Item : Report) return Law_Words is
     (Item (Active), Item (Invalid_Low), Item (Invalid_High), Item (Silent),
      Item (Failed), Item (Configuration))
   with Global => null;

   function Recorded_Of (Memory : URV.LAW_Steps.Kept) return Recorded_Laws is
     ((Laws  => Words_Of
         (Report_Of
            (Memory.Flown, Surface_Monitor.Failed_Bits (Memory.Watched),
             Memory.Set)),
       Cards => Card_Status.State_Word (Memory.Cards.Run)))
   with Global => null;

   --  It is large, and LAW changes it in place. By its priority a bare machine
   --  masks no interrupts meanwhile.
   protected type Memory_Store with Priority => System.Priority'Last is

      --  LAW's frame.
      procedure Decide
        (Usual  : URV.Laws.Settings;
         Got    : URV.LAW_Steps.Inputs;
         Result : out URV.LAW_Steps.Decision);

      procedure Write (Item : URV.LAW_Steps.Kept);

      function Contents return URV.LAW_Steps.Kept;

      --  Parts of the contents

      function Link return URV.Link_Loss.Link_State;

      function Cards return URV.Test_Runs.Run;

      function Recorded return Recorded_Laws;

   private
      Kept : URV.LAW_Steps.Kept := URV.LAW_Steps.At_Start;
   end Memory_Store;

   --  LAW writes them when its memory has changed.
   package Records is new URVOS.Shared_Data
     (Recorded_Laws, Initial => Recorded_Of (URV.LAW_Steps.At_Start));

   package Settings is new URVOS.Shared_Data
     (URV.Laws.Settings, Initial => URV.Laws.Laws_Off);

end URV.Shared_Laws;
