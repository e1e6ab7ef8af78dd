--  SPDX-License-Identifier: Apache-2.0

--  The ground's events in the model of Theorems.Safety (SAF-2). Each event of
--  a task receives, calls the task's own decision functions and sends, in the
--  same order as the task. The tasks' shells that do this in flight are not
--  proved equal to these; tests compare them.

private package Theorems.Safety.Ground_Events with SPARK_Mode, Ghost is

   procedure End_Scan (Item : in out Ground_Way; Scans : Scan_History)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   => Is_Sound (Item, Scans) and then Item.Done >= Item'Old.Done;

   procedure Run_AD
     (Item : in out Ground_Way; Scans : Scan_History; Got : AD_Inputs)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   =>
       Is_Sound (Item, Scans)
       and then Item.Done = Item'Old.Done
       and then
         (if not Is_Fresh (Item'Old.ADINT)
            and then
              (Got.Schedule = Report
               or else
                 (Is_Over (Got.Timeout, Got.Time)
                  and then
                    Item'Old.Scanning.Doing = URV.AD_Steps.Scanning
                  and then Item'Old.Scanning.Received = 0))
          then Contents (Item.AD).Error_Status = Stale_Data);

   procedure Run_GDCOUT
     (Item       : in out Ground_Way;
      Scans      : Scan_History;
      Bits       : Word;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   =>
       Is_Sound (Item, Scans)
       and then Item.Done = Item'Old.Done
       and then
         (if not Is_Fresh (Item'Old.AD)
            or else Contents (Item'Old.AD).Error_Status = Stale_Data
          then Is_Old (Contents (Item.TELOUT))
            or else Is_Other_Kind (Contents (Item.TELOUT)));

   procedure Run_TELOUT
     (Item  : in out Ground_Way;
      Line  : in out Line_Way;
      Scans : Scan_History)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans) and then Is_Sound (Line, Scans, Item.Done),
     Post   =>
       Is_Sound (Item, Scans)
       and then Item.Done = Item'Old.Done
       and then Is_Sound (Line, Scans, Item.Done);

   procedure Start_Ground
     (Item : in out Ground_Way; Scans : Scan_History; Cold : Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   => Is_Sound (Item, Scans) and then Item.Done = Item'Old.Done;

end Theorems.Safety.Ground_Events;
