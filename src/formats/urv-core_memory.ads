--  SPDX-License-Identifier: Apache-2.0

--  CORE memory: the ground station's displays and recorders read the latest
--  data here (report, 2.3.4, 2.5, 4.3; BUF-4).
--
--  Each item is a word and a type code that identifies it. The status area
--  describes the node itself. Only a cold start clears it, so it also counts
--  the warm starts (INI-6).

with URVOS;       use URVOS;
with URV.Buffers; use URV.Buffers;

package URV.CORE_Memory with Pure, SPARK_Mode is

   --  The words before the first message of a frame. No data has come, so that
   --  they are marked as old (INI-6, SAF-5).

   No_Uplink : constant Uplink_Buffer :=
     (Error_Status => Stale_Data, others => 0);

   No_Downlink : constant Downlink_Buffer :=
     (Error_Status => Stale_Data, others => 0);

   --  The type codes of an area's words.

   type Uplink_Code_List is array (Uplink_Item) of Word;

   type Downlink_Code_List is array (Downlink_Item) of Word;

   --  The words of the status area. A count of one word stops at its last
   --  value. In a pair the high word precedes the low word.
   type Status_Item is

      --  The last start: 1 cold start, 2 warm reset, 3 processor restart; then
      --  the number of starts of each kind.
     (Start_Condition,
      Cold_Starts,
      Warm_Resets,
      Processor_Restarts,

      --  The result of the last start's self-test, or of the RAM in flight; 0
      --  if all tests passed.
      Self_Test_Result,

      --  The check in flight: the number of passes that found the whole ROM
      --  right, and of those that found a difference.
      ROM_Passes,
      ROM_Failures,

      --  From the error log: the number of errors; the last one's kind, by its
      --  place in the list of kinds from 1; and its major frame. All are 0 if
      --  there was no error.
      Error_Total_High,
      Error_Total_Low,
      Last_Error,
      Last_Error_Frame_High,
      Last_Error_Frame_Low);

   type Status_Array is array (Status_Item range <>) of Word;

   subtype Status_Words is Status_Array (Status_Item);

   --  The error logs: a row for each kind of error, in the order of the kinds
   --  (EXT-1, SAF-7). A row without errors is all 0. Rows have no type codes;
   --  their place identifies them. The last row of the aircraft's log belongs
   --  to the control laws (EXT-3).

   type Log_Field is
     (Occurrences_High, Occurrences_Low,
      First_Frame_High, First_Frame_Low,
      Last_Frame_High, Last_Frame_Low,
      Last_Detail);

   type Log_Row is array (Log_Field) of Word;

   No_Errors : constant Log_Row := (others => 0);

   type Log_Row_Number is range 1 .. 40;
   type Log_Rows is array (Log_Row_Number) of Log_Row;

   type Memory is record
      Uplink_Codes   : Uplink_Code_List   := (others => 0);
      Uplink         : Uplink_Buffer      := No_Uplink;
      Downlink_Codes : Downlink_Code_List := (others => 0);
      Downlink       : Downlink_Buffer    := No_Downlink;

      --  The frame of these words. Its place identifies a word.
      Frame          : Frame_Words        := Unknown_Frame;
      Status_Codes   : Status_Words       := (others => 0);
      Status         : Status_Words       := (others => 0);

      --  The node's own log, and on the ground its knowledge of the aircraft's
      --  log.
      Log            : Log_Rows           := (others => No_Errors);
      Aircraft_Log   : Log_Rows           := (others => No_Errors);
   end record;

   --  An area with its type codes.

   type Coded_Uplink is record
      Codes : Uplink_Code_List;
      Words : Uplink_Buffer;
   end record;

   type Coded_Downlink is record
      Codes : Downlink_Code_List;
      Words : Downlink_Buffer;
   end record;

   --  The memory after a cold start (INI-6).
   Cleared : constant Memory := (others => <>);

   --  The memory after a warm start: the old words, marked as old in their
   --  error/status words (SAF-5).
   function Marked_Old (Item : Memory) return Memory is
     ((Item with delta
         Uplink   => As_Old (Item.Uplink),
         Downlink => As_Old (Item.Downlink)))
   with Global => null;

   --  A count of one word after one more event.
   function Incremented (Value : Word) return Word is
     (if Value = Word'Last then Value else Value + 1)
   with Global => null;

end URV.CORE_Memory;
