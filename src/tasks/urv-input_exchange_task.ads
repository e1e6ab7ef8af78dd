--  SPDX-License-Identifier: Apache-2.0

--  Input exchange task: what the other node sent goes to those who use it.
--  Released at minor frame 1.
--
--  MDCIN in the aircraft (report, 4.6, table 6; MDI-1, D-11, D-14) consumes
--  TELIN_variable, produces uplink_variable and PWM_variable. GDCIN on the
--  ground (5.5, table 9; GDI-1, D-14) consumes TELIN_variable, produces
--  downlink_variable. A frame with nothing new passes on the message before,
--  marked as old.
--
--  A block of another kind than its direction's own goes to whoever takes
--  that kind. One that nobody takes is reported, and goes nowhere (EXT-2).
--  Either way the others get what they got last, marked as old.

with URVOS;             use URVOS;
with URVOS.Shared_Mailboxes;
with URV.Errors;        use URV.Errors;
with URV.Routing;       use URV.Routing;
with URV.Shared_Errors; use URV.Shared_Errors;

generic
   with package Messages is new URVOS.Shared_Mailboxes (<>);
   TELIN_Variable : in out Messages.Variable;

   --  uplink_variable or downlink_variable, and what is said when it is
   --  overwritten.
   CORE_Variable     : in out Messages.Variable;
   CORE_Not_Consumed : Error_Kind;

   Errors : in out Shared_Log;

   with function As_Old
     (Source : Messages.Message) return Messages.Message;

   --  Its place in the buffer, 0 when there is none.
   with function First_Out_Of_Range
     (Source : Messages.Message) return Place_Count;

   --  The message as it is in CORE.
   with function For_CORE
     (Source : Messages.Message) return Messages.Message;

   --  To whom else it goes.
   with procedure Deliver (Item : Messages.Message);

   --  Blocks of another kind.

   with function Is_Other_Kind
     (Source : Messages.Message) return Boolean;
   with function Kind_Of (Source : Messages.Message) return Word;

   --  To whom such a one goes. Taken is False when its kind is unknown.
   with procedure Deliver_Other
     (Item  : Messages.Message;
      Taken : out Boolean);
package URV.Input_Exchange_Task with SPARK_Mode is

   procedure Run_Transaction;

end URV.Input_Exchange_Task;
