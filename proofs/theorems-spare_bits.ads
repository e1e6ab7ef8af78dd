--  SPDX-License-Identifier: Apache-2.0

--  The frame in the spare bits of a downlink (FTI-12, D-11, D-98): it arrives
--  unchanged, none of its bits is taken for one of a sensor's word, no block
--  with it is taken for one of format 2, and the numbers of two frames show
--  exactly how many lie between them.

with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Task_Trees;  use URVOS.Task_Trees;
with URV.Buffers;       use URV.Buffers;
with URV.Codecs;
with URV.MDCOUT_Steps;
with URV.Plain_Blocks;
with URV.Seal_Blocks;
with URV.Spare_Bits;    use URV.Spare_Bits;

package Theorems.Spare_Bits with Pure, SPARK_Mode, Ghost is

   --  Unpacking restores what was packed: each sensor's word, limited to 12
   --  bits, the error/status word, and the frame.
   procedure What_Is_Packed_Comes
     (Source : Downlink_Buffer; Frame : Frame_Words)
   with
     Global => null,
     Post   =>
       (for all Item in Sensor_Item =>
          Sensors_In (Packed (Source, Frame)) (Item) =
            Clipped (Source (Item)))
       and then Sensors_In (Packed (Source, Frame)) (Error_Status) =
                  Source (Error_Status)
       and then
         (if Is_Sendable (Frame)
          then
            (for all Item in Frame_Item =>
               Frame_In (Packed (Source, Frame)) (Item) = Frame (Item)));

   --  Words of a converter arrive as they are.
   procedure Converter_Words_Come
     (Source : Downlink_Buffer; Frame : Frame_Words)
   with
     Global => null,
     Post   =>
       (for all Item in Sensor_Item =>
          (if Source (Item) in Converter_Value
           then Sensors_In (Packed (Source, Frame)) (Item) =
                  Source (Item)));

   --  A block with a frame is not taken for a sealed one or a hello.
   procedure No_Block_Looks_Sealed
     (Source : Downlink_Buffer; Frame : Frame_Words)
   with
     Global => null,
     Post   =>
       URV.Seal_Blocks.Mark_Of
         (URV.Plain_Blocks.Encode
            (URV.Codecs.Downlink.Words_Of (Packed (Source, Frame)),
             URV.Codecs.Downlink.Words))
         not in URV.Seal_Blocks.Sealed_Mark | URV.Seal_Blocks.Hello_Mark;

   --  A block of an older aircraft, whose words have 12 bits, has no frame,
   --  and its words arrive as they are.
   procedure An_Older_Block_Has_No_Frame (Source : Downlink_Buffer)
   with
     Global => null,
     Pre    =>
       (for all Item in Sensor_Item => Source (Item) in Converter_Value),
     Post   =>
       not Is_Marked (Source)
       and then
         (for all Item in Downlink_Item =>
            Sensors_In (Source) (Item) = Source (Item))
       and then
         (for all Item in Frame_Item =>
            Frame_In (Source) (Item) = Unknown_Word);

   --  Equal words have equal frames and sensors.
   procedure Equal_Words_Have_Equal_Frames (One, Other : Downlink_Buffer)
   with
     Global => null,
     Pre    =>
       (for all Item in Downlink_Item => One (Item) = Other (Item)),
     Post   =>
       (for all Item in Frame_Item =>
          Frame_In (One) (Item) = Frame_In (Other) (Item))
       and then
         (for all Item in Downlink_Item =>
            Sensors_In (One) (Item) = Sensors_In (Other) (Item));

   --  The difference of two numbers: the ground's count of frames from one to
   --  the other.
   function Frames_From (One, Other : Converter_Value) return Natural is
     ((Integer (Other) - Integer (One)) mod Frame_Numbers)
   with Global => null;

   --  Between the downlinks of two frames, up to 4095 apart, the difference of
   --  their numbers is the number of frames.
   procedure Numbers_Count_Frames
     (Before, After : Clock_Tick; Set : Schedule_Name)
   with
     Global => null,
     Pre    =>
       After / Ticks_Per_Major_Frame - Before / Ticks_Per_Major_Frame
         in 0 .. 4_095,
     Post   =>
       Tick
         (Frames_From
            (URV.MDCOUT_Steps.Number_Of (Before, Set),
             URV.MDCOUT_Steps.Number_Of (After, Set))) =
         After / Ticks_Per_Major_Frame - Before / Ticks_Per_Major_Frame;

end Theorems.Spare_Bits;
