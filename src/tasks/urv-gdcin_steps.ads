--  SPDX-License-Identifier: Apache-2.0

--  The decision of the GDCIN task (D-70): what CORE is given of a message in
--  TELIN_variable, which fragment of the aircraft's error log it carries, and
--  what is reported (report, 5.5; GDI-1, D-11, D-14, EXT-2, SAF-7). The task
--  receives, calls these functions, sends and reports. Each is an expression
--  function: its text is its contract; a procedure in place has it as its
--  postcondition. Messages have their spare bits until the last step,
--  Spare_Bits.Unpack (FTI-12).

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Log_Pieces; use URV.Log_Pieces;
with URV.Routing;    use URV.Routing;
with URV.Spare_Bits;
with URV.Type_Codes; use URV.Type_Codes;

package URV.GDCIN_Steps with Pure, SPARK_Mode is

   --  The message as received. If the block is of another kind, it is instead
   --  the last message of CORE, marked as old.
   function Passed_On
     (Item  : Downlink_Buffer;
      Fresh : Boolean;
      Last  : Downlink_Buffer) return Downlink_Buffer
   is
     (if Is_Other_Kind (Item) then As_Old (Last)
      elsif Fresh then Item
      else As_Old (Item))
   with Global => null;

   --  The same in place, if the block is of this kind.
   procedure Pass_On (Item : in out Downlink_Buffer; Fresh : Boolean)
   with
     Global => null,
     Pre    => not Is_Other_Kind (Item),
     Post   => Item = Passed_On (Item'Old, Fresh, Last => Item'Old);

   --  The message that the task keeps: without the log's fragment.
   function To_Keep (Message : Downlink_Buffer) return Downlink_Buffer is
     ((Message with delta
         Error_Status => Without_Piece (Message (Error_Status))))
   with Global => null;

   --  The same in place. Next is the fragment.
   procedure Take_Off (Message : in out Downlink_Buffer; Next : out Piece)
   with
     Global => null,
     Post   =>
       Message = To_Keep (Message'Old)
       and then Next = Piece_Of (Message'Old (Error_Status));

   --  A fragment of the log is taken once, in the frame of its arrival.
   function Has_Piece (Message : Downlink_Buffer) return Boolean is
     (not Is_Old (Message))
   with Global => null;

   --  A new block of another kind. An old one was taken or reported when it
   --  came.
   function Is_New_Kind
     (Item : Downlink_Buffer; Fresh : Boolean) return Boolean
   is
     (Fresh and then Is_Other_Kind (Item) and then not Is_Old (Item))
   with Global => null;

   --  The block is of the aircraft's flight recorder (FTI-10).
   function Is_Of_Recorder
     (Item : Downlink_Buffer; Fresh : Boolean) return Boolean
   is
     (Is_New_Kind (Item, Fresh)
      and then Kind_Of (Item) in Recorder_Kind | Recorder_Report_Kind)
   with Global => null;

   --  Such a block without the spare bits, which format 2 sets.
   function Without_Frame (Item : Downlink_Buffer) return Downlink_Buffer is
     (Spare_Bits.Sensors_In (Item))
   with Global => null;

   --  The block is for no task; this is an error.
   function Is_Unknown
     (Item : Downlink_Buffer; Fresh : Boolean) return Boolean
   is
     (Is_New_Kind (Item, Fresh)
      and then Kind_Of (Item) not in Recorder_Kind | Recorder_Report_Kind)
   with Global => null;

   --  The place of the first new sensor that is out of range, from 1; 0 if
   --  there is none.
   function Place_Out_Of_Range
     (Item : Downlink_Buffer; Fresh : Boolean) return Routing.Place_Count
   is
     (if Fresh and then not Is_Other_Kind (Item)
      then First_Out_Of_Range (Spare_Bits.Sensors_In (Item))
      else 0)
   with Global => null;

   --  Whether there is one. A block with spare bits has none.
   function Has_Out_Of_Range
     (Item : Downlink_Buffer; Fresh : Boolean) return Boolean
   is
     (Fresh
      and then not Is_Other_Kind (Item)
      and then not Spare_Bits.Is_Marked (Item)
      and then First_Out_Of_Range (Item) > 0)
   with
     Global => null,
     Post   =>
       Has_Out_Of_Range'Result = (Place_Out_Of_Range (Item, Fresh) > 0);

end URV.GDCIN_Steps;
