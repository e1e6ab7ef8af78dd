--  SPDX-License-Identifier: Apache-2.0

package body Sim.Hardware_Faults is

   Waiting : Fault_List;
   Place   : Positive := 1;

   procedure Prepare (From : Script) is
   begin
      Waiting := Of_Hardware (From);
      Place := 1;
   end Prepare;

   function Next_Time return Microseconds is
     (if Place <= Waiting.Last_Index then Waiting (Place).Time
      else Never);

   procedure Take_Next (Item : out Fault) is
   begin
      Item := Waiting (Place);
      Place := Place + 1;
   end Take_Next;

end Sim.Hardware_Faults;
