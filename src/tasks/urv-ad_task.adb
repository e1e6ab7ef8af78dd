--  SPDX-License-Identifier: Apache-2.0

with URVOS;            use URVOS;
with URVOS.Task_Trees; use URVOS.Task_Trees;
with URV.Errors;       use URV.Errors;

package body URV.AD_Task with SPARK_Mode is

   procedure Hand_On (Item : AD_Image);

   --  Begins a frame's first scan. Had_None reports that the frame before had
   --  no scan.
   procedure Begin_First_Scan (Had_None : Boolean);

   --  Discards a scan that ended after its minor frame; its words are too old.
   procedure Discard_Late_Scan;

   --  The report's transaction: sends on the last frame's scan and begins the
   --  next.
   procedure Take_Last_Scan;

   --  One step of a frame in the fast schedule.
   procedure Follow_Scans (Now : Clock_Tick);

   procedure Hand_On (Item : AD_Image) is
      Success : Boolean;
   begin
      AD_Variable.Send (Item, Success);
      if not Success then
         Errors.Report (Image_Not_Consumed, 0);
      end if;
   end Hand_On;

   procedure Begin_First_Scan (Had_None : Boolean) is
      Reached : Channel_Count;
   begin
      Begin_Scan (Reached);
      if Had_None then
         Errors.Report (AD_No_Scan, Word (Reached));
      end if;
   end Begin_First_Scan;

   procedure Discard_Late_Scan is
      Unused_Item  : Channel_Words;
      Unused_Fresh : Boolean;
   begin
      ADINT_Variable.Look (Unused_Item, Unused_Fresh);
   end Discard_Late_Scan;

   procedure Take_Last_Scan is
      Item  : Channel_Words;
      Fresh : Boolean;
   begin
      ADINT_Variable.Receive (Item, Fresh);
      Hand_On (Last_Image (Item, Fresh));
      Begin_First_Scan (Had_None => not Fresh);
   end Take_Last_Scan;

   procedure Follow_Scans (Now : Clock_Tick) is
      Kept           : Progress := Present.Contents;
      Item           : Channel_Words;
      Fresh          : Boolean;
      Look_Again     : Boolean;
      Chosen         : Action;
      Unused_Reached : Channel_Count;
   begin
      if Kept.Doing /= Scanning then
         Begin_First_Scan (Had_None => Kept.Doing = Had_No_Scan);
         Discard_Late_Scan;
         Present.Write (Scan_Begun (Now));
         return;
      end if;

      Receiving.Receive_Step (Now, Kept.Timeout, Item, Fresh, Look_Again);
      Kept := Counted (Kept, Fresh);
      Chosen := Next_Action (Kept, Fresh, Look_Again, Fast_Scans, Now);
      case Chosen is
         when Begin_Another_Scan => Begin_Scan (Unused_Reached);
         when Hand_On_Image      => Hand_On (Newest_Image (Item, Kept));
         when Wait_For_Scan      => null;
      end case;
      Present.Write (After (Kept, Chosen));
   end Follow_Scans;

   procedure Initialise is
      Set            : constant Schedule_Name := Schedule.Contents;
      Unused_Reached : Channel_Count;
   begin
      Present.Write ((others => <>));
      if Set = Report then
         Begin_Scan (Unused_Reached);
      end if;
   end Initialise;

   procedure Run_Transaction (Now : Clock_Tick) is
      Set : constant Schedule_Name := Schedule.Contents;
   begin
      case Set is
         when Report => Take_Last_Scan;
         when Fast   => Follow_Scans (Now);
      end case;
   end Run_Transaction;

   procedure Await_Scan (Call : in out Kernel_Call) is
      Item : constant Progress := Present.Contents;
   begin
      if Item.Doing = Scanning then
         Call := (Exit_Call, others => <>);
      end if;
   end Await_Scan;

end URV.AD_Task;
