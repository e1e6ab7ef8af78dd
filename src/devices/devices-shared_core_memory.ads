--  A CORE memory between the controller and its readers (report, 4.3;
--  COR-1).

with Devices.CORE_Memory; use Devices.CORE_Memory;

generic
package Devices.Shared_CORE_Memory
  with
    SPARK_Mode,
    Abstract_State =>
      (CORE with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => CORE
is

   --  The controller's side.

   procedure Clear
   with Global => (In_Out => CORE);

   procedure Write_Codes
     (Uplink_Codes   : Uplink_Words;
      Downlink_Codes : Downlink_Words;
      Status_Codes   : Status_Words)
   with
     Global  => (In_Out => CORE),
     Depends =>
       (CORE => (CORE, Uplink_Codes, Downlink_Codes, Status_Codes));

   procedure Write_Uplink (Words : Uplink_Words)
   with
     Global  => (In_Out => CORE),
     Depends => (CORE => (CORE, Words));

   procedure Write_Downlink (Words : Downlink_Words)
   with
     Global  => (In_Out => CORE),
     Depends => (CORE => (CORE, Words));

   --  Writes the words of the status area that are given, at one instant;
   --  the others stay.
   procedure Write_Status (Words : Status_Array)
   with
     Global  => (In_Out => CORE),
     Depends => (CORE => (CORE, Words));

   --  A row of the node's own log, or of the aircraft's.

   procedure Write_Log (Which : Log_Row_Number; Row : Log_Row)
   with
     Global  => (In_Out => CORE),
     Depends => (CORE => (CORE, Which, Row));

   procedure Write_Aircraft_Log (Which : Log_Row_Number; Row : Log_Row)
   with
     Global  => (In_Out => CORE),
     Depends => (CORE => (CORE, Which, Row));

   --  The readers' side: all of it, at one instant.
   procedure Inspect (Snapshot : out Memory)
   with
     Global  => (Input => CORE),
     Depends => (Snapshot => CORE);

end Devices.Shared_CORE_Memory;
