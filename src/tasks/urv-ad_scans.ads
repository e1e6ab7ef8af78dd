--  SPDX-License-Identifier: Apache-2.0

--  One scan of the 32 channels (report, 4.2, figure 6; ADI-1, D-19, SAF-2).
--
--  The interrupt handler stores a word and gets its next action. Between scans
--  no interrupt is expected; an unexpected one stores nothing.

with Devices.AD_Board; use Devices.AD_Board;
with URVOS;            use URVOS;
with URVOS.Frames;     use URVOS.Frames;
with URV.Buffers;      use URV.Buffers;

package URV.AD_Scans with Pure, SPARK_Mode is

   --  The channel under conversion. After the last channel the scan is
   --  complete.
   type Channel_Count is range 0 .. Channel_Words'Length;

   --  The number of scans in a row, and the number that fit in a tick.

   type Scan_Count is range 0 .. 7;

   Scans_In_A_Tick : constant Scan_Count :=
     Microseconds_Per_Tick
     / (Channel_Words'Length * Microseconds_Per_Conversion);

   type Scan is record
      Current : Channel_Count := Channel_Count'Last;
      Words   : Channel_Words := (others => Neutral_Value);
   end record;

   function Is_Complete (This : Scan) return Boolean is
     (This.Current = Channel_Count'Last)
   with Global => null;

   --  The scan begins again with channel 0. Each word remains until its
   --  channel is stored again.
   function Restarted (This : Scan) return Scan is
     ((This with delta Current => 0))
   with Global => null;

   --  The same in place
   procedure Begin_Again (This : in out Scan)
   with
     Inline,
     Global => null,
     Post   => This = Restarted (This'Old);

   type Next_Step is
     (Start_Channel,   --  start the conversion of the current channel
      Send_Words,      --  all channels have been stored
      Ignore,          --  the interrupt was not expected
      Discard);        --  the conversion was abandoned: no interrupt

   --  The channel to convert after a conversion whose value was passed on, or
   --  one of three reasons for none.
   type Successor is range 0 .. Channel_Words'Length + 2;
   subtype Next_Channel is Successor range 0 .. Channel_Words'Length - 1;

   Nothing_Wanted : constant Successor := Channel_Words'Length;
   Scan_Complete  : constant Successor := Channel_Words'Length + 1;
   Not_Expected   : constant Successor := Channel_Words'Length + 2;

   --  The word of the current channel has been converted.
   procedure Store
     (This  : in out Scan;
      Value : Word;
      Next  : out Next_Step)
   with
     Inline,
     Global         => null,
     Contract_Cases =>
       (Is_Complete (This) =>
          Next = Ignore and then This = This'Old,
        others =>
          This.Current = This'Old.Current + 1
          and then This.Words =
            (This'Old.Words with delta Channel (This'Old.Current) => Value)
          and then Next =
            (if Is_Complete (This) then Send_Words else Start_Channel));

end URV.AD_Scans;
