package body URVOS.Start_Orders with SPARK_Mode is

   procedure Look
     (State : in out Node_State;
      Who   : Seat;
      Todo  : out Order) is
   begin
      Todo := (others => <>);
      if State.Doing = Running and then State.Is_Wanted then
         State.Doing := Stopping;
         State.Done := (others => False);
      end if;

      case State.Doing is
         when Running =>
            Todo.Name := Carry_On;

         when Stopping =>
            State.Done (Who) := True;
            if Who = Master and then All_Done (State) then
               State.Doing := Testing;
               State.Is_Wanted := False;
               Todo := (Begin_Start, State.Wanted, others => <>);
            end if;

         when Testing =>
            null;

         when Loading =>
            if State.Done (Who) then
               Todo.Name := Carry_On;
            else
               State.Done (Who) := True;
               Todo :=
                 (Name      => Load_Tasks,
                  Condition => State.Wanted,
                  Passed    => State.Passed,
                  Number    => Who);
               if All_Done (State) then
                  State.Doing := Running;
               end if;
            end if;
      end case;
   end Look;

end URVOS.Start_Orders;
