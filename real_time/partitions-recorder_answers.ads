--  SPDX-License-Identifier: Apache-2.0

--  The blocks of the aircraft's flight recorder on the way to the program that
--  fetches it (FTI-10): each that comes down goes to the last sender of a
--  request, in one datagram. docs/station-packets.md has its layout.

with Interfaces.C;            use Interfaces.C;
with Partitions.System_Calls; use Partitions.System_Calls;

package Partitions.Recorder_Answers is

   --  The words of the last downlink are those of a flying aircraft. A request
   --  then does not go up, and its sender gets the aircraft's answer.
   function Is_Flying return Boolean;

   --  A request has come to that socket, from that address.
   procedure Note_Sender
     (Port : File; Where : Socket_Address; Length : unsigned);

   procedure Refuse_In_Flight;

   --  Sends the block that has come in this frame, if any. Never waits.
   procedure Pass_On;

end Partitions.Recorder_Answers;
