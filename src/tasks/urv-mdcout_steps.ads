--  SPDX-License-Identifier: Apache-2.0

--  The decision of the MDCOUT task (D-70): the message that is made of an
--  image of the converter, and what of it goes down (report, 4.7; MDO-1, D-1,
--  D-14, TST-4, SAF-7). The task receives, calls these functions, sends and
--  reports. Each is an expression function: its text is its contract.

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Log_Pieces; use URV.Log_Pieces;
with URV.Routing;    use URV.Routing;
with URV.Type_Codes; use URV.Type_Codes;

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

   --  The message for the ground, with a fragment of the error log.
   function For_Link
     (Message : Downlink_Buffer; Next : Piece) return Downlink_Buffer
   is
     ((Message with delta
         Error_Status => With_Piece (Message (Error_Status), Next)))
   with Global => null;

end URV.MDCOUT_Steps;
