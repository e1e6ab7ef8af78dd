--  The aircraft's control system in its partition: the flight
--  software's tasks, and the hardware of its boards.

with MCS;
with Partitions.Measurements; use Partitions.Measurements;
with Telemetry.Boards;
with URVOS;                   use URVOS;
with URV.Errors;

package Partitions.MCS_Node is

   --  What the transactions of each task took, and when they ended after
   --  the tick of their minor frame; in tenths of microseconds.
   Costs     : array (MCS.Task_Name) of Distribution;
   Responses : array (MCS.Task_Name) of Distribution;

   --  How late the clock ticked, in tenths of microseconds.
   Lateness : Distribution;

   --  Power up of every board.
   procedure Switch_On;

   function Overruns return Count;

   --  What the telemetry board has counted.
   function Link_Tally return Telemetry.Boards.Statistics;

   --  How often the node has found that it had stood still.
   function Pauses return Count;

   --  How often the telemetry board's processor has found that it had.
   function Board_Starts return Count;

   function Log return URV.Errors.Error_Log;

end Partitions.MCS_Node;
