--  SPDX-License-Identifier: Apache-2.0

--  LAW's memory from frame to frame (the laws' memory, the ground's settings,
--  the monitor of surfaces), the words of it that the flight recorder records,
--  and the laws' settings (EXT-2, EXT-3, EXT-5, EXT-6, FTI-9). A warm start
--  keeps them.

pragma SPARK_Mode;

with URVOS.Shared_Data;
with URV.Card_Status;
with URV.LAW_Steps;
with URV.Laws;
with URV.Law_Status;    use URV.Law_Status;
with URV.Recorder_Rows; use URV.Recorder_Rows;
with URV.Surface_Monitor;

package URV.Shared_Laws is

   package Memories is new URVOS.Shared_Data
     (URV.LAW_Steps.Kept, Initial => URV.LAW_Steps.At_Start);

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

   --  LAW writes them when its memory has changed: the memory is a large copy.
   package Records is new URVOS.Shared_Data
     (Recorded_Laws, Initial => Recorded_Of (URV.LAW_Steps.At_Start));

   package Settings is new URVOS.Shared_Data
     (URV.Laws.Settings, Initial => URV.Laws.Laws_Off);

end URV.Shared_Laws;
