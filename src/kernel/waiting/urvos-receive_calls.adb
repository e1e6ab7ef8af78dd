package body URVOS.Receive_Calls with SPARK_Mode is

   procedure Receive_Step
     (Patience   : in out Wait;
      Item       : out Message;
      Fresh      : out Boolean;
      Look_Again : out Boolean)
   is
      Now : Clock_Tick;
   begin
      Read_Clock (Now);
      if Is_Over (Patience, Now) then
         Receive (Item, Fresh);
         Look_Again := False;
      else
         Look (Item, Fresh);
         Look_Again := not Fresh;
         if Look_Again then
            Note_Look (Patience, Now);
         end if;
      end if;
   end Receive_Step;

   procedure Receive_Within
     (Ticks : Wait_Ticks;
      Item  : out Message;
      Fresh : out Boolean)
   is
      Now        : Clock_Tick;
      Patience   : Wait;
      Look_Again : Boolean;
   begin
      Read_Clock (Now);
      Patience := Begun (Now, Ticks);
      loop
         Receive_Step (Patience, Item, Fresh, Look_Again);
         exit when not Look_Again;
         Exit_Processor;
         pragma Loop_Variant (Decreases => Looks_Left (Patience));
      end loop;
   end Receive_Within;

end URVOS.Receive_Calls;
