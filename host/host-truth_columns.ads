--  SPDX-License-Identifier: Apache-2.0

--  The columns truth.* of a flight record: the true state of the aircraft in
--  JSBSim, in engineering units.

with Host.Plant_Messages; use Host.Plant_Messages;
with Host.Text_Output;    use Host.Text_Output;

package Host.Truth_Columns is

   --  Each with a comma before it.
   procedure Put_Names (To : in out Writer);
   procedure Put_Values (To : in out Writer; Shown : Shown_State);

end Host.Truth_Columns;
