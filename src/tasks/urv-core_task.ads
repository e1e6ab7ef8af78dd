--  CORE task: keeps the node's CORE memory up to date (report, 4.3, table
--  3; COR-1). Released at minor frame 4.
--
--  Consumes uplink_variable and downlink_variable, produces the CORE uplink
--  and downlink areas. What has not arrived anew is not written again. The
--  type codes are written when the task first runs (INI-7).

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS;               use URVOS;
with URV.Buffers;         use URV.Buffers;
with URV.Errors;          use URV.Errors;

generic
   with procedure Receive_Uplink
     (Item : out Uplink_Buffer; Fresh : out Boolean);
   with procedure Receive_Downlink
     (Item : out Downlink_Buffer; Fresh : out Boolean);
   with procedure Write_Codes
     (Uplink_Codes   : Uplink_Words;
      Downlink_Codes : Downlink_Words;
      Status_Codes   : Status_Words);
   with procedure Write_Uplink (Words : Uplink_Words);
   with procedure Write_Downlink (Words : Downlink_Words);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.CORE_Task
  with
    SPARK_Mode,
    Abstract_State => First_Run,
    Initializes    => First_Run
is

   procedure Initialise;

   procedure Run_Transaction;

end URV.CORE_Task;
