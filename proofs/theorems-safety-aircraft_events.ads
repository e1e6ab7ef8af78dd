--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's events in the model of Theorems.Safety (SAF-2). Each event
--  of a task receives, calls the task's own decision functions and sends, in
--  the same order as the task. The tasks' shells that do this in flight are
--  not proved equal to these; tests compare them.

private package Theorems.Safety.Aircraft_Events with SPARK_Mode, Ghost is

   procedure Run_TELIN
     (Item  : in out Aircraft_Way;
      Line  : Line_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Which : Block_Count)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans, Done) and then Is_Sound (Line, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then Item.Board = Item'Old.Board
       and then
         (if Which = 0 and then Item'Old.Kept.Has_Message
          then Is_Old (Contents (Item.TELIN)));

   procedure Run_MDCIN
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then Item.Board = Item'Old.Board
       and then
         (if not Is_Fresh (Item'Old.TELIN)
            or else Is_Other_Kind (Contents (Item'Old.TELIN))
          then Is_Old (Contents (Item.Uplink))
            and then Is_Old (Contents (Item.Commands)))
       and then
         (if Is_Other_Kind (Contents (Item'Old.TELIN))
          then Item.Uplink_From = Item'Old.Uplink_From)
       and then Is_Fresh (Item.Commands);

   procedure Run_LAW
     (Item  : in out Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Usual : URV.Laws.Settings;
      Law   : URV.LAW_Steps.Kept;
      Got   : URV.LAW_Steps.Inputs)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then Item.Board = Item'Old.Board
       and then
         (if Is_Fresh (Item'Old.Commands)
            and then
              (not Usual.On
               or else URV.Laws.Is_Disconnected
                 (Contents (Item'Old.Commands)))
          then not Item.PWM_By_Law
            and then not Item.PWM_By_Card
            and then Item.Added = Nothing_Added
            and then Item.PWM_Sticks = No_Sticks
            and then Contents (Item.PWM) = Contents (Item'Old.Commands))
       and then
         (if Is_Fresh (Item'Old.Commands)
            and then Is_Old (Contents (Item'Old.Commands))
            and then not Item.PWM_By_Law
            and then not Item.PWM_By_Card
          then Is_Old (Contents (Item.PWM)));

   procedure Run_PWM
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then
         (if not Is_Fresh (Item'Old.PWM)
            or else Is_Old (Contents (Item'Old.PWM))
          then Item.Board = Item'Old.Board);

   procedure Run_CORE
     (Item : in out Aircraft_Way; Scans : Scan_History; Done : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done) and then Item.Board = Item'Old.Board;

   procedure Start_Aircraft
     (Item  : in out Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count;
      Cold  : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Is_Sound (Item, Scans, Done)
       and then
         (if Cold
          then Item.Board = URV.PWM_Layout.Safe_Area
          else Item.Board = Item'Old.Board);

end Theorems.Safety.Aircraft_Events;
