--  SPDX-License-Identifier: Apache-2.0

--  PWM task: gives the servos the pilot's commands (report, 4.8, table 8;
--  PWM-1). Released at minor frame 2.
--
--  Consumes PWM_variable, produces the data area of the PWM board. When
--  nothing new has come, or commands that are marked as old, it leaves the
--  board's words alone (SAF-2, SAF-3, D-14). Whoever marked them has reported
--  why. The board's timer is touched in every frame (SAF-11).
--  Surfaces that have failed are made up for by the others (EXT-6).

with URV.Mailboxes;     use URV.Mailboxes;
with URV.PWM_Boards;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Surfaces;

generic
   PWM_Variable   : in out For_Uplink.Variable;
   Surface_Health : in out URV.Shared_Surfaces.Healths.Store;
   PWM_Board      : in out PWM_Boards.Board;
   Errors         : in out Shared_Log;
package URV.PWM_Task with SPARK_Mode is

   procedure Run_Transaction
   with
     Global =>
       (Input  => Surface_Health,
        In_Out => (PWM_Variable, PWM_Board, Errors));

end URV.PWM_Task;
