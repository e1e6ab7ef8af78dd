--  SPDX-License-Identifier: Apache-2.0

with Ada.Containers.Vectors;

package body Sim.Hardware_Faults is

   package Fault_Vectors is new Ada.Containers.Vectors (Positive, Fault);

   --  Two faults never stand on one line.
   function Is_Before (Left, Right : Fault) return Boolean is
     (if Left.Time = Right.Time then Left.Line < Right.Line
      else Left.Time < Right.Time);

   package Sorting is new Fault_Vectors.Generic_Sorting ("<" => Is_Before);

   Waiting : Fault_Vectors.Vector;
   Place   : Positive := 1;

   procedure Prepare (From : Script) is
      Item : Fault;
   begin
      Waiting.Clear;
      Place := 1;
      for Index in 1 .. Length (From) loop
         Item := Element (From, Index);
         if Item.Kind in Reset | ROM_Harm | RAM_Harm | Bus_Error then
            Waiting.Append (Item);
         end if;
      end loop;
      Sorting.Sort (Waiting);
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
