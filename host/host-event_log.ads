--  SPDX-License-Identifier: Apache-2.0

--  The error logs of the nodes as JSON lines, one for each node and kind of
--  error that occurred (--events; EXT-1). docs/error-log.md explains the
--  fields.

with Host.Text_Output;
with URV.Errors; use URV.Errors;

package Host.Event_Log is

   --  The time of a tick of the node's clock.
   generic
      with function Time_Of (Now : Clock_Tick) return Microseconds;

   --  Writes a node's log in the order of the kinds. Each node counts its own
   --  frames.
   procedure Write
     (To   : in out Text_Output.Writer;
      Node : String;
      Log  : Error_Log)
     with Pre => Text_Output.Is_Open (To);

end Host.Event_Log;
