--  SPDX-License-Identifier: Apache-2.0

--  The decision of the GDCOUT task (D-70): the message that is made of an
--  image of the converter, and what goes up (report, 5.6; GDO-1, D-3, D-14,
--  TST-4, EXT-2). The task receives, calls these functions, sends and reports;
--  Theorems.Safety calls the same functions. Each is an expression function:
--  its text is its contract.

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Routing;    use URV.Routing;
with URV.Type_Codes; use URV.Type_Codes;

package URV.GDCOUT_Steps with Pure, SPARK_Mode is

   --  The message for CORE, with the node's own status bits. A frame without a
   --  new image uses the last one, marked as old.
   function Message_Of
     (Image : AD_Image;
      Fresh : Boolean;
      Codes : Channel_Codes;
      Bits  : Word) return Uplink_Buffer
   is
     (if Fresh then Marked (Commands_Of (Image, Codes), Bits)
      else As_Old (Marked (Commands_Of (Image, Codes), Bits)))
   with Global => null;

   --  The message for the aircraft. A console order of another kind replaces a
   --  frame's commands.
   function For_Link
     (Message    : Uplink_Buffer;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean) return Uplink_Buffer
   is
     (if Is_Ordered and then Is_Other_Kind (Order) then Order else Message)
   with Global => null;

end URV.GDCOUT_Steps;
