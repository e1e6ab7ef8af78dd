--  SPDX-License-Identifier: Apache-2.0

--  The decision of the MDCOUT task (D-70): the message that is made of an
--  image of the converter, its frame, and what of both goes down (report, 4.7;
--  MDO-1, D-1, D-11, D-14, TST-4, SAF-7, FTI-12). The task receives, calls
--  these functions, sends and reports. Each is an expression function: its
--  text is its contract; a procedure in place has it as its postcondition.

with Devices.PWM_Board; use Devices.PWM_Board;
with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Task_Trees;  use URVOS.Task_Trees;
with URV.Buffers;       use URV.Buffers;
with URV.Log_Pieces;    use URV.Log_Pieces;
with URV.PWM_Layout;    use URV.PWM_Layout;
with URV.Routing;       use URV.Routing;
with URV.Spare_Bits;    use URV.Spare_Bits;
with URV.Type_Codes;    use URV.Type_Codes;

package URV.MDCOUT_Steps with Pure, SPARK_Mode is

   --  The message for CORE and the laws, with the node's own status bits. A
   --  frame without a new image uses the last one, marked as old.
   function Message_Of
     (Image : AD_Image;
      Fresh : Boolean;
      Codes : Channel_Codes;
      Bits  : Word) return Downlink_Buffer
   is
     (if Fresh then Marked (Sensors_Of (Image, Codes), Bits)
      else As_Old (Marked (Sensors_Of (Image, Codes), Bits)))
   with Global => null;

   --  The number of the frame of a message's scan, modulo 4096. The report's
   --  schedule hands on the scan of the frame before.
   function Number_Of (Now : Clock_Tick; Set : Schedule_Name)
                       return Converter_Value
   is
     (Word
        ((Now / Ticks_Per_Major_Frame
          + (if Set = Fast then 0 else Frame_Numbers - 1))
         mod Frame_Numbers))
   with Global => null;

   --  The frame of a message. Card is URV.Card_Status.Card_Word; Area has the
   --  servos' words, as they were while the sensors were scanned.
   function Frame_Of
     (Now  : Clock_Tick;
      Set  : Schedule_Name;
      Card : Word;
      Area : Data_Area) return Frame_Words
   is
     (Frame_Number   => Number_Of (Now, Set),
      Running_Card   => Middle (Card),
      Card_Phase     => Low (Card),
      Left_Aileron   => Clipped (Area (Channel_Of (Left_Aileron))),
      Right_Aileron  => Clipped (Area (Channel_Of (Right_Aileron))),
      Left_Elevator  => Clipped (Area (Channel_Of (Left_Elevator))),
      Right_Elevator => Clipped (Area (Channel_Of (Right_Elevator))),
      Left_Rudder    => Clipped (Area (Channel_Of (Left_Rudder))),
      Right_Rudder   => Clipped (Area (Channel_Of (Right_Rudder))),
      Throttle       => Clipped (Area (Channel_Of (Throttle))))
   with
     Global => null,
     Post   => Is_Sendable (Frame_Of'Result);

   --  The message for the ground, with its frame and a fragment of the error
   --  log.
   function For_Link
     (Message : Downlink_Buffer; Frame : Frame_Words; Next : Piece)
      return Downlink_Buffer
   is
     (Packed
        ((Message with delta
            Error_Status => With_Piece (Message (Error_Status), Next)),
         Frame))
   with Global => null;

   --  The same in place.
   procedure Add_Frame
     (Message : in out Downlink_Buffer; Frame : Frame_Words; Next : Piece)
   with
     Global => null,
     Post   => Message = For_Link (Message'Old, Frame, Next);

   --  A new sensor that is out of range goes down limited, and is reported by
   --  its type code.

   function Has_Out_Of_Range (Message : Downlink_Buffer; Fresh : Boolean)
                              return Boolean
   is (Fresh and then First_Out_Of_Range (Message) > 0)
   with Global => null;

   function Code_Out_Of_Range (Message : Downlink_Buffer) return Word is
     (Sensors_Kind + Word (First_Out_Of_Range (Message)))
   with Global => null;

end URV.MDCOUT_Steps;
