--  SPDX-License-Identifier: Apache-2.0

with URVOS;            use URVOS;
with URVOS.Task_Trees; use URVOS.Task_Trees;
with URV.Errors;       use URV.Errors;
with URV.Routing;

package body URV.AD_Task with SPARK_Mode is

   --  Hands on the words of the last scan.
   procedure Hand_On (Fresh : out Boolean);

   --  Of a scan that ends later than its minor frame the words are too old.
   procedure Discard_Late_Scan;

   procedure Hand_On (Fresh : out Boolean) is
      Item    : Channel_Words;
      Success : Boolean;
   begin
      ADINT_Variable.Receive (Item, Fresh);
      AD_Variable.Send (Routing.Stamped (Item, Fresh), Success);
      if not Success then
         Errors.Report (Image_Not_Consumed, 0);
      end if;
   end Hand_On;

   procedure Discard_Late_Scan is
      Unused_Item  : Channel_Words;
      Unused_Fresh : Boolean;
   begin
      ADINT_Variable.Receive (Unused_Item, Unused_Fresh);
   end Discard_Late_Scan;

   procedure Initialise is
      Set            : constant Schedule_Name := Schedule.Contents;
      Unused_Reached : Channel_Count;
   begin
      Doing.Write (Had_Scan);
      if Set = Report then
         Begin_Scan (Unused_Reached);
      end if;
   end Initialise;

   procedure Run_Transaction is
      Set     : constant Schedule_Name := Schedule.Contents;
      Before  : constant Progress      := Doing.Contents;
      Fresh   : Boolean                := Before /= Had_No_Scan;
      Reached : Channel_Count;
   begin
      if Set = Report or else Before = Scanning then
         Hand_On (Fresh);
         Doing.Write (if Fresh then Had_Scan else Had_No_Scan);
      end if;

      if Set = Report or else Before /= Scanning then
         Begin_Scan (Reached);
         if not Fresh then
            Errors.Report (AD_No_Scan, Word (Reached));
         end if;
         if Set = Fast then
            Discard_Late_Scan;
            Doing.Write (Scanning);
         end if;
      end if;
   end Run_Transaction;

   procedure Await_Scan (Now : Clock_Tick; Call : in out Kernel_Call) is
      Present : constant Progress := Doing.Contents;
   begin
      if Present = Scanning then
         Call := (Sleep_Call, Until_Tick => Now + 1, others => <>);
      end if;
   end Await_Scan;

end URV.AD_Task;
