--  SPDX-License-Identifier: Apache-2.0

--  PWM task: writes the pilot's commands to the servos (report, 4.8, table 8;
--  PWM-1). Released at minor frame 2 of the report's schedule.
--
--  Consumes PWM_variable, produces the data area of the PWM board. Without new
--  commands, or with commands marked as old, it leaves the board's words
--  unchanged (SAF-2, SAF-3, D-14). The task that marked them has reported the
--  reason. It touches the board's timer in every frame (SAF-11). The other
--  surfaces make up for failed ones (EXT-6). A test card adds its inputs
--  (FTI-3).

with URV.Mailboxes;     use URV.Mailboxes;
with URV.PWM_Boards;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Inputs;
with URV.Shared_Surfaces;

generic
   PWM_Variable   : in out For_Uplink.Variable;
   Surface_Health : in out URV.Shared_Surfaces.Healths.Store;
   Test_Added     : in out URV.Shared_Inputs.Store;
   PWM_Board      : in out PWM_Boards.Board;
   Errors         : in out Shared_Log;
package URV.PWM_Task with SPARK_Mode is

   procedure Run_Transaction
   with
     Global =>
       (Input  => (Surface_Health, Test_Added),
        In_Out => (PWM_Variable, PWM_Board, Errors));

end URV.PWM_Task;
