--  SPDX-License-Identifier: Apache-2.0

--  Output exchange task: what the converter held goes to CORE and to the
--  other node. Released at minor frame 1.
--
--  MDCOUT in the aircraft (report, 4.7, table 7; MDO-1, D-1, D-14) consumes
--  AD_variable, produces downlink_variable and TELOUT_variable. GDCOUT on
--  the ground (5.6, table 10; GDO-1, D-3, D-14) consumes AD_variable,
--  produces uplink_variable and TELOUT_variable. A frame with nothing new
--  passes on the data before, marked as old. The node's own bits are added
--  to the error/status word (TST-4).
--
--  Each channel's word goes to the item of its type code. A channel whose
--  code nobody knows is reported, and its word goes nowhere (EXT-2).

with URVOS;             use URVOS;
with URVOS.Shared_Mailboxes;
with URV.Buffers;       use URV.Buffers;
with URV.Errors;        use URV.Errors;
with URV.Routing;       use URV.Routing;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Status; use URV.Shared_Status;
with URV.Type_Codes;    use URV.Type_Codes;

generic
   with package Images is
     new URVOS.Shared_Mailboxes (Message => AD_Image, others => <>);
   with package Messages is new URVOS.Shared_Mailboxes (<>);
   AD_Variable : in out Images.Variable;

   --  uplink_variable or downlink_variable, and what is said when it is
   --  overwritten.
   CORE_Variable     : in out Messages.Variable;
   CORE_Not_Consumed : Error_Kind;

   TELOUT_Variable : in out Messages.Variable;
   Node_Status     : in out Status;
   Errors          : in out Shared_Log;

   --  What the channels are, the message that their words make, and the
   --  first of them, from 1, that is no item of it; 0 is none.

   Codes : Channel_Codes;

   with function To_Message
     (Image : AD_Image; Codes : Channel_Codes) return Messages.Message;
   with function First_Unknown (Codes : Channel_Codes) return Unknown_Count;

   with function Marked
     (Source : Messages.Message; Bits : Word) return Messages.Message;
   with function As_Old
     (Source : Messages.Message) return Messages.Message;

   --  What goes along on the link alone.
   with procedure Add_For_Link (Item : in out Messages.Message);
package URV.Output_Exchange_Task with SPARK_Mode is

   procedure Run_Transaction;

end URV.Output_Exchange_Task;
