--  SPDX-License-Identifier: Apache-2.0

--  The decision of the MDCIN task (D-70): what CORE and the laws are given of
--  a message in TELIN_variable, and what is reported (report, 4.6; MDI-1,
--  D-11, D-14, EXT-2). The task receives, calls these functions, sends and
--  reports; Theorems.Safety calls the same functions. Each is an expression
--  function: its text is its contract.

with URV.Buffers;    use URV.Buffers;
with URV.Routing;    use URV.Routing;
with URV.Type_Codes; use URV.Type_Codes;

package URV.MDCIN_Steps with Pure, SPARK_Mode is

   --  The message for CORE and the laws. If the block is of another kind, it
   --  is instead the last message, marked as old.
   function Passed_On
     (Item  : Uplink_Buffer;
      Fresh : Boolean;
      Last  : Uplink_Buffer) return Uplink_Buffer
   is
     (if Is_Other_Kind (Item) then As_Old (Last)
      elsif Fresh then Item
      else As_Old (Item))
   with Global => null;

   --  A new block of another kind. An old one was taken or reported when it
   --  came.
   function Is_New_Kind
     (Item : Uplink_Buffer; Fresh : Boolean) return Boolean
   is
     (Fresh and then Is_Other_Kind (Item) and then not Is_Old (Item))
   with Global => null;

   --  The block is for the laws: a configuration or a test card.
   function Is_For_Laws
     (Item : Uplink_Buffer; Fresh : Boolean) return Boolean
   is
     (Is_New_Kind (Item, Fresh)
      and then Kind_Of (Item) in Configuration_Kind | Test_Card_Kind)
   with Global => null;

   --  The block is a request for rows of the flight recorder (FTI-10).
   function Is_For_Recorder
     (Item : Uplink_Buffer; Fresh : Boolean) return Boolean
   is
     (Is_New_Kind (Item, Fresh) and then Kind_Of (Item) in Recorder_Kind)
   with Global => null;

   --  The block is for no task; this is an error.
   function Is_Unknown
     (Item : Uplink_Buffer; Fresh : Boolean) return Boolean
   is
     (Is_New_Kind (Item, Fresh)
      and then Kind_Of (Item) not in
                 Configuration_Kind | Test_Card_Kind | Recorder_Kind)
   with Global => null;

   --  The place of the first new command that is out of range, from 1; 0 if
   --  there is none.
   function Place_Out_Of_Range
     (Item : Uplink_Buffer; Fresh : Boolean) return Place_Count
   is
     (if Fresh and then not Is_Other_Kind (Item)
      then First_Out_Of_Range (Item)
      else 0)
   with Global => null;

end URV.MDCIN_Steps;
