--  SPDX-License-Identifier: Apache-2.0

--  Sends the flight recorder's rows to the ground on its request (FTI-10), in
--  place of sensors, while the aircraft is on the ground. In flight a request
--  is answered once and changes nothing.

with URVOS.Shared_Data;
with URV.Buffers;        use URV.Buffers;
with URV.Mailboxes;      use URV.Mailboxes;
with URV.Recorder_Steps; use URV.Recorder_Steps;
with URV.Shared_Recorders;

generic
   Requests : in out For_Uplink.Variable;
   Recorder : in out URV.Shared_Recorders.Recorder;
package URV.Recorder_Senders with SPARK_Mode is

   package Lines is new URVOS.Shared_Data (Line, Initial => (others => <>));

   Progress : Lines.Store;

   --  A start ends the sending.
   procedure Restart
   with Global => (In_Out => Progress);

   --  Sensors are the aircraft's in this frame. If Is_Sent, Block goes down in
   --  their place.
   procedure Next
     (Sensors : Downlink_Buffer;
      Block   : out Downlink_Buffer;
      Is_Sent : out Boolean)
   with Global => (In_Out => (Requests, Recorder, Progress));

end URV.Recorder_Senders;
