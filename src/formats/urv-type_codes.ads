--  SPDX-License-Identifier: Apache-2.0

--  Type codes (report, 2.5, 4.3.1; BUF-4, EXT-2, FTI-1): the high byte of a
--  code names a kind of message, the low byte an item of it, from 1.
--
--  Type codes direct the data. A converter channel goes to the item of its
--  code in the node's list. A block from the other node goes to the users of
--  its kind. A word of CORE memory belongs to the item of the code beside it.
--  Data with an unknown code is discarded.
--
--  The line has no room for a code beside each word. A block gives its kind
--  once, in its error/status word. Without a kind, an uplink carries commands
--  and a downlink sensors. In an uplink, one bit says that the first word is
--  the kind. In a downlink, the kind's high byte replaces the fragment of the
--  log (D-26).

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Log_Pieces; use URV.Log_Pieces;

package URV.Type_Codes with Pure, SPARK_Mode is

   --  A channel without an item.
   No_Code : constant Word := 0;

   Commands_Kind      : constant Word := 16#0100#;
   Sensors_Kind       : constant Word := 16#0200#;
   Status_Kind        : constant Word := 16#0300#;
   Configuration_Kind : constant Word := 16#0400#;
   Test_Card_Kind     : constant Word := 16#0500#;

   --  FTI-10: an uplink's request for rows of the flight recorder and, in a
   --  downlink, the rows; and the report that precedes them.
   Recorder_Kind        : constant Word := 16#0700#;
   Recorder_Report_Kind : constant Word := 16#0800#;

   subtype Uplink_Code is Word range
     Commands_Kind + 1
     .. Commands_Kind + Uplink_Item'Pos (Uplink_Item'Last) + 1;

   subtype Command_Code is Uplink_Code range
     Commands_Kind + 1
     .. Commands_Kind + Uplink_Item'Pos (Command_Item'Last) + 1;

   subtype Downlink_Code is Word range
     Sensors_Kind + 1
     .. Sensors_Kind + Downlink_Item'Pos (Downlink_Item'Last) + 1;

   subtype Sensor_Code is Downlink_Code range
     Sensors_Kind + 1
     .. Sensors_Kind + Downlink_Item'Pos (Sensor_Item'Last) + 1;

   function Code_Of (Item : Uplink_Item) return Uplink_Code is
     (Commands_Kind + 1 + Word (Uplink_Item'Pos (Item)))
   with Global => null;

   function Code_Of (Item : Downlink_Item) return Downlink_Code is
     (Sensors_Kind + 1 + Word (Downlink_Item'Pos (Item)))
   with Global => null;

   function Uplink_Item_Of (Code : Uplink_Code) return Uplink_Item is
     (Uplink_Item'Val (Integer (Code) - Integer (Commands_Kind) - 1))
   with
     Global => null,
     Post   => Code_Of (Uplink_Item_Of'Result) = Code;

   function Downlink_Item_Of (Code : Downlink_Code) return Downlink_Item is
     (Downlink_Item'Val (Integer (Code) - Integer (Sensors_Kind) - 1))
   with
     Global => null,
     Post   => Code_Of (Downlink_Item_Of'Result) = Code;

   --  The items of the converter's channels, as wired (D-47). No item has two
   --  channels. No code selects an item of the control laws (D-48)

   type Channel_Codes is array (Channel) of Word;

   function Stick_Codes return Channel_Codes is
     ([for Where in Channel =>
         (if Where <= Uplink_Item'Pos (Command_Item'Last)
          then Commands_Kind + 1 + Word (Where) else No_Code)])
   with Global => null;

   function Sensor_Codes return Channel_Codes is
     ([for Where in Channel =>
         (if Where <= Downlink_Item'Pos (Sensor_Item'Last)
          then Sensors_Kind + 1 + Word (Where) else No_Code)])
   with Global => null;

   function Is_Unique (Codes : Channel_Codes) return Boolean is
     (for all One in Channel =>
        (for all Other in Channel =>
           (if One /= Other and then Codes (One) /= No_Code
            then Codes (One) /= Codes (Other))))
   with Global => null;

   --  The kind that a block gives. A block of another kind is never taken for
   --  its direction's own kind, whatever its first word

   function Is_Other_Kind (Source : Uplink_Buffer) return Boolean is
     ((Source (Error_Status) and Other_Kind) /= 0)
   with Global => null;

   subtype Kind_Byte is Piece range 1 .. 255;

   function Is_Other_Kind (Source : Downlink_Buffer) return Boolean is
     (Piece_Of (Source (Error_Status)) in Kind_Byte)
   with Global => null;

   function Kind_Of (Source : Uplink_Buffer) return Word is
     (if Is_Other_Kind (Source) then Source (Uplink_Item'First)
      else Commands_Kind)
   with Global => null;

   function Kind_Of (Source : Downlink_Buffer) return Word is
     (if Is_Other_Kind (Source)
      then Piece_Of (Source (Error_Status)) * 256
      else Sensors_Kind)
   with Global => null;

end URV.Type_Codes;
