with Ada.Real_Time; use Ada.Real_Time;

with Partitions.Clocks;

procedure Partitions.Guarded_Step
  (First_Run : Boolean; Failed : out Boolean)
is
   Began : constant Time := Clock;
   Ended : Time;
begin
   if First_Run then
      Initialise;
   else
      Run_Transaction;
      Ended := Clock;
      Cost.Add (Clocks.Tenths_Of_Microseconds (Ended - Began));
      Response.Add (Clocks.Tenths_Of_Microseconds (Ended - Clocks.Tick));
      Observe;
   end if;
   Failed := False;
exception
   when others =>
      Failed := True;
end Partitions.Guarded_Step;
