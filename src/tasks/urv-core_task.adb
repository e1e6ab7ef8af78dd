--  SPDX-License-Identifier: Apache-2.0

with URV.Buffers;     use URV.Buffers;
with URV.CORE_Layout; use URV.CORE_Layout;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.CORE_Steps;  use URV.CORE_Steps;
with URV.Errors;      use URV.Errors;

package body URV.CORE_Task with SPARK_Mode is

   procedure Take_Uplink;

   procedure Take_Downlink;

   --  An area with a code that is not the usual one: each word goes to the
   --  place of its code. Rare, and out of the path of all other frames.

   procedure Store_By_Code (Item : Uplink_Buffer)
   with No_Inline;

   procedure Store_By_Code (Item : Framed_Downlink)
   with No_Inline;

   procedure Store_By_Code (Item : Uplink_Buffer) is
      Area : constant Coded_Uplink := CORE_Memory.Uplink_Area;
   begin
      CORE_Memory.Write_Uplink (Words_After (Area, Item));
      if Has_Unknown (Area.Codes) then
         Errors.Report (Unknown_Code, First_Unknown (Area.Codes));
         Codes_Wanted.Write (True);
      end if;
   end Store_By_Code;

   procedure Store_By_Code (Item : Framed_Downlink) is
      Area : constant Coded_Downlink := CORE_Memory.Downlink_Area;
   begin
      CORE_Memory.Write_Downlink (Words_After (Area, Item.Words), Item.Frame);
      if Has_Unknown (Area.Codes) then
         Errors.Report (Unknown_Code, First_Unknown (Area.Codes));
         Codes_Wanted.Write (True);
      end if;
   end Store_By_Code;

   procedure Take_Uplink is
      Item      : Uplink_Buffer;
      Fresh     : Boolean;
      Is_Stored : Boolean;
   begin
      Uplink_Variable.Receive (Item, Fresh);
      if Is_Written (Fresh) then
         CORE_Memory.Store_Uplink (Item, Is_Stored);
         if not Is_Stored then
            Store_By_Code (Item);
         end if;
      else
         Errors.Report (CORE_No_Uplink, 0);
      end if;
   end Take_Uplink;

   procedure Take_Downlink is
      Item      : Framed_Downlink;
      Fresh     : Boolean;
      Is_Stored : Boolean;
   begin
      Downlink_Variable.Receive (Item, Fresh);
      if Is_Written (Fresh) then
         CORE_Memory.Store_Downlink (Item.Words, Item.Frame, Is_Stored);
         if not Is_Stored then
            Store_By_Code (Item);
         end if;
      else
         Errors.Report (CORE_No_Downlink, 0);
      end if;
   end Take_Downlink;

   procedure Initialise is
   begin
      Codes_Wanted.Write (True);
   end Initialise;

   procedure Run_Transaction is
      First_Run : constant Boolean := Codes_Wanted.Contents;
   begin
      if First_Run then
         CORE_Memory.Write_Codes
           (Uplink_Type_Codes, Downlink_Type_Codes, Status_Type_Codes);
         Codes_Wanted.Write (False);
      end if;
      Take_Uplink;
      Take_Downlink;
   end Run_Transaction;

end URV.CORE_Task;
