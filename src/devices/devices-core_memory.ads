--  SPDX-License-Identifier: Apache-2.0

--  CORE memory, where the ground station's displays and recorders find the
--  latest data (report, 2.3.4, 2.5, 4.3; BUF-4).
--
--  Each item is a word and the type code that says what it is. The status
--  area is for what the node has to say of itself; only a cold start clears
--  it, so that it tells of the warm ones (INI-6).

with URVOS;       use URVOS;
with URV.Buffers; use URV.Buffers;

package Devices.CORE_Memory with Pure, SPARK_Mode is

   --  Items are numbered from 1, in the order of their buffer.
   type Item_Number is range 1 .. Downlink_Item'Pos (Downlink_Item'Last) + 1;
   type Word_Array is array (Item_Number range <>) of Word;

   subtype Uplink_Words is
     Word_Array (1 .. Uplink_Item'Pos (Uplink_Item'Last) + 1);
   subtype Downlink_Words is Word_Array (Item_Number);

   --  The words of the status area. A count of one word stays at its last
   --  value; of a pair the high word stands first.
   type Status_Item is

      --  Of the last start: 1 cold start, 2 warm reset, 3 processor restart;
      --  and how often there was one.
     (Start_Condition,
      Cold_Starts,
      Warm_Resets,
      Processor_Restarts,

      --  Of the last start; 0 when all was well.
      Self_Test_Result,

      --  Of the check in flight: how often it went through the whole ROM,
      --  and how often it found a difference.
      ROM_Passes,
      ROM_Failures,

      --  From the error log: how many there were; the kind of the last one,
      --  its place in the list of kinds, from 1; the major frame it was in.
      --  All are 0 when there was none.
      Error_Total_High,
      Error_Total_Low,
      Last_Error,
      Last_Error_Frame_High,
      Last_Error_Frame_Low);

   type Status_Array is array (Status_Item range <>) of Word;

   subtype Status_Words is Status_Array (Status_Item);

   --  The error logs: a row for each kind of error, in the order of the
   --  kinds (EXT-1, SAF-7). All of it is 0 where there was none. Rows have
   --  no type codes: their place says what they are. The last row of the
   --  aircraft's is the control laws' (EXT-3).

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
      Uplink_Codes   : Uplink_Words   := (others => 0);
      Uplink         : Uplink_Words   := (others => 0);
      Downlink_Codes : Downlink_Words := (others => 0);
      Downlink       : Downlink_Words := (others => 0);
      Status_Codes   : Status_Words   := (others => 0);
      Status         : Status_Words   := (others => 0);

      --  The node's own log; on the ground, what is known of the aircraft's.
      Log            : Log_Rows       := (others => No_Errors);
      Aircraft_Log   : Log_Rows       := (others => No_Errors);
   end record;

   --  An area with its type codes.

   type Coded_Uplink is record
      Codes, Words : Uplink_Words;
   end record;

   type Coded_Downlink is record
      Codes, Words : Downlink_Words;
   end record;

   --  What a cold start leaves (INI-6).
   Cleared : constant Memory := (others => <>);

   --  What a warm start leaves: the words are of before it, and marked so in
   --  their error/status words (SAF-5).
   function Marked_Old (Item : Memory) return Memory is
     ((Item with delta
         Uplink   =>
           (Item.Uplink with delta
              Uplink_Words'Last =>
                Item.Uplink (Uplink_Words'Last) or Stale_Data),
         Downlink =>
           (Item.Downlink with delta
              Downlink_Words'Last =>
                Item.Downlink (Downlink_Words'Last) or Stale_Data)))
   with Global => null;

   --  A memory with another row of the node's own log, or of the aircraft's.
   --  All else stays.

   function With_Log
     (This : Memory; Which : Log_Row_Number; Row : Log_Row) return Memory
   is
     ((This with delta Log => (This.Log with delta Which => Row)))
   with
     Global => null,
     Post   =>
       With_Log'Result.Log (Which) = Row
       and then With_Log'Result.Aircraft_Log = This.Aircraft_Log;

   function With_Aircraft_Log
     (This : Memory; Which : Log_Row_Number; Row : Log_Row) return Memory
   is
     ((This with delta
         Aircraft_Log => (This.Aircraft_Log with delta Which => Row)))
   with
     Global => null,
     Post   =>
       With_Aircraft_Log'Result.Aircraft_Log (Which) = Row
       and then With_Aircraft_Log'Result.Log = This.Log;

   --  A count of one word after one more.
   function Incremented (Value : Word) return Word is
     (if Value = Word'Last then Value else Value + 1)
   with Global => null;

end Devices.CORE_Memory;
