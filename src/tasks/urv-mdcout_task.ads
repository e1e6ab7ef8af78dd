--  SPDX-License-Identifier: Apache-2.0

--  MDCOUT task: gives the sensors to CORE, to the laws and to the ground
--  (report, 4.7, table 7; MDO-1, D-1, D-14). Released at minor frame 1 of the
--  report's schedule.
--
--  Consumes AD_variable, produces downlink_variable, sensors_variable and
--  TELOUT_variable. A frame without a new image passes on the last data,
--  marked as old. The node's own bits are added to the error/status word
--  (TST-4). The downlink also carries a fragment of the error log (SAF-7), and
--  in its spare bits the frame's number, the running test card and the servos'
--  words; CORE gets these, too (FTI-12). On the ground a row of the flight
--  recorder may go down in place of the sensors (FTI-10).
--
--  Each channel's word goes to the item of its type code. A channel with an
--  unknown code is reported, and its word is discarded (EXT-2).

with URVOS.Frames;      use URVOS.Frames;
with URV.Buffers;       use URV.Buffers;
with URV.Log_Pieces;    use URV.Log_Pieces;
with URV.Mailboxes;     use URV.Mailboxes;
with URV.PWM_Boards;
with URV.Shared_Cards;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Schedules;
with URV.Shared_Status; use URV.Shared_Status;
with URV.Type_Codes;    use URV.Type_Codes;

generic
   AD_Variable       : in out For_Sensor_Images.Variable;
   Downlink_Variable : in out For_Framed_Downlink.Variable;
   Sensors_Variable  : in out For_Downlink.Variable;
   TELOUT_Variable   : in out For_Downlink.Variable;
   Node_Status       : in out Status;
   Card_Shown        : in out URV.Shared_Cards.Store;
   PWM_Board         : in out PWM_Boards.Board;
   Schedule          : in out URV.Shared_Schedules.Store;
   Errors            : in out Shared_Log;
   Codes             : Channel_Codes;
   with procedure Next_Piece (Item : out Piece);

   --  A block of the flight recorder, in place of the sensors.
   with procedure Next_Block
     (Sensors : Downlink_Buffer;
      Block   : out Downlink_Buffer;
      Is_Sent : out Boolean);
package URV.MDCOUT_Task with SPARK_Mode is

   procedure Run_Transaction (Now : Clock_Tick);

end URV.MDCOUT_Task;
