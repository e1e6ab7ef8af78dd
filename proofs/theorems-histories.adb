--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Histories with SPARK_Mode is

   --  If no step between two sends, the last sender is the same.
   procedure Same_Last_Sent (Item : History; Earlier, Later : Step_Count)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Later),
     Pre                =>
       Earlier <= Later and then Last_Sent (Item, Later) <= Earlier,
     Post               =>
       Last_Sent (Item, Later) = Last_Sent (Item, Earlier);

   procedure Mailbox_Gives_The_Newest
     (Item  : History;
      Up_To : Step_Count;
      Gave  : out Outcomes)
   is
      Box     : Mailbox := Empty_Mailbox;
      Message : Step_Count;
      Success : Boolean;

      --  The last step so far that sent, and the last that consumed.
      Newest : Step_Count := 0;
      Taken  : Step_Count := 0;
   begin
      Gave := (others => (False, 0));
      --  The state before the first step; the provers need it shown.
      pragma Assert (Last_Sent (Item, 0) = 0);
      pragma Assert (Last_Consumed (Item, 0) = 0);
      for Now in Step range 1 .. Up_To loop
         pragma Assert (Newest = Last_Sent (Item, Now - 1));
         pragma Assert (Taken = Last_Consumed (Item, Now - 1));
         case Item (Now) is
            when Sends =>
               Send (Box, Now, Success);
               Message := Now;
               Newest := Now;
            when Looks =>
               Look (Box, Message, Success);
               Taken := Now;
            when Receives =>
               Receive (Box, Message, Success);
               Taken := Now;
         end case;
         Gave (Now) := (Success, Message);
         pragma Assert (Is_Given (Item, Now, Gave (Now)));
         pragma Loop_Invariant (Newest = Last_Sent (Item, Now));
         pragma Loop_Invariant (Taken = Last_Consumed (Item, Now));
         pragma Loop_Invariant (Contents (Box) = Newest);
         pragma Loop_Invariant (Is_Fresh (Box) = (Newest > Taken));
         pragma Loop_Invariant (Is_Given_Up_To (Item, Gave, Now));
      end loop;
   end Mailbox_Gives_The_Newest;

   procedure Last_Sent_Is_The_Last
     (Item : History; Up_To : Step_Count; Since : Step) is
   begin
      if Item (Up_To) /= Sends then
         if Since < Up_To then
            Last_Sent_Is_The_Last (Item, Up_To - 1, Since);
         elsif Up_To > 1 then
            Last_Sent_Is_The_Last (Item, Up_To - 1, Up_To - 1);
         end if;
      end if;
   end Last_Sent_Is_The_Last;

   procedure Last_Consumed_Is_The_Last
     (Item : History; Up_To : Step_Count; Since : Step) is
   begin
      if not Consumes (Item (Up_To)) then
         if Since < Up_To then
            Last_Consumed_Is_The_Last (Item, Up_To - 1, Since);
         elsif Up_To > 1 then
            Last_Consumed_Is_The_Last (Item, Up_To - 1, Up_To - 1);
         end if;
      end if;
   end Last_Consumed_Is_The_Last;

   procedure Same_Last_Sent (Item : History; Earlier, Later : Step_Count) is
   begin
      if Earlier < Later then
         Same_Last_Sent (Item, Earlier, Later - 1);
      end if;
   end Same_Last_Sent;

   procedure A_Received_Message_Was_Sent
     (Item : History;
      Gave : Outcomes;
      Now  : Step)
   is
      Newest : constant Step_Count := Last_Sent (Item, Now - 1);
      Taken  : constant Step_Count := Last_Consumed (Item, Now - 1);
   begin
      pragma Assert (Is_Given (Item, Now, Gave (Now)));
      pragma Assert (Gave (Now).Message = Newest);
      pragma Assert (Gave (Now).Success = (Newest > Taken));
      if Now > 1 then
         Last_Sent_Is_The_Last (Item, Now - 1, Now - 1);
      end if;
      pragma Assert (if Newest > 0 then Item (Newest) = Sends);
   end A_Received_Message_Was_Sent;

   procedure Fresh_Once_And_In_Order
     (Item           : History;
      Gave           : Outcomes;
      Earlier, Later : Step) is
   begin
      pragma Assert (Is_Given (Item, Earlier, Gave (Earlier)));
      pragma Assert (Is_Given (Item, Later, Gave (Later)));
      pragma Assert (Gave (Earlier).Message = Last_Sent (Item, Earlier - 1));
      pragma Assert (Gave (Later).Message = Last_Sent (Item, Later - 1));
      Last_Consumed_Is_The_Last (Item, Later - 1, Earlier);
      pragma Assert (Last_Consumed (Item, Later - 1) >= Earlier);
   end Fresh_Once_And_In_Order;

   procedure None_Is_Lost_But_Overwritten
     (Item      : History;
      Gave      : Outcomes;
      Sent, Now : Step;
      Taken     : out Step)
   is
      Before : constant Step_Count := Last_Consumed (Item, Now - 1);
   begin
      pragma Assert (Is_Given (Item, Now, Gave (Now)));
      Last_Sent_Is_The_Last (Item, Now - 1, Sent);
      if Gave (Now).Success then
         Taken := Now;
      else
         --  The consumer has consumed since the last send.
         Last_Consumed_Is_The_Last (Item, Now - 1, Sent);
         None_Is_Lost_But_Overwritten (Item, Gave, Sent, Before, Taken);
      end if;
   end None_Is_Lost_But_Overwritten;

   procedure Old_Is_The_Last_Given
     (Item           : History;
      Gave           : Outcomes;
      Earlier, Later : Step) is
   begin
      pragma Assert (Is_Given (Item, Earlier, Gave (Earlier)));
      pragma Assert (Is_Given (Item, Later, Gave (Later)));
      Last_Consumed_Is_The_Last (Item, Later - 1, Earlier);
      Same_Last_Sent (Item, Earlier, Later - 1);
   end Old_Is_The_Last_Given;

end Theorems.Histories;
