with Ada.Real_Time; use Ada.Real_Time;

with Partitions.Clocks;
with Partitions.Exceptions;

procedure Partitions.Guarded_Step
  (First_Run : Boolean; Failed : out Boolean)
is
   Began : constant Time := Clock;
   Ended : Time;
begin
   Failed := False;
   if First_Run then
      Initialise;

      --  The start before it may have taken its time.
      Clocks.See_Tick;
   elsif Has_Stood_Still then
      Failed := True;
   else
      Run_Transaction;
      Ended := Clock;
      Cost.Add (Clocks.Tenths_Of_Microseconds (Ended - Began));
      Response.Add (Clocks.Tenths_Of_Microseconds (Ended - Clocks.Tick));
      Observe;
   end if;
exception
   when Error : others =>
      Exceptions.Tell (Error);
      Failed := True;
end Partitions.Guarded_Step;
