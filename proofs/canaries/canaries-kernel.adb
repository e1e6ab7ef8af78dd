--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Kernel with SPARK_Mode is

   package body Ceilings is

      protected body Box is
         procedure Put (Item : Word) is
         begin
            Contents := Item;
         end Put;
      end Box;

      task body Writer is
      begin
         loop
            Box.Put (1);
         end loop;
      end Writer;

      task body Once is
      begin
         null;
      end Once;

   end Ceilings;

   package body Races is

      task body Up is
      begin
         loop
            Frames := Incremented (Frames);
         end loop;
      end Up;

      task body Down is
      begin
         loop
            Frames := 0;
         end loop;
      end Down;

   end Races;

   package body Mailboxes is

      procedure Send_Twice (Box : in out Mailbox; Item : Channel_Words) is
         First, Second : Boolean;
      begin
         Send (Box, Item, First);
         Send (Box, Item, Second);
         pragma Assert (not Second);
         pragma Unreferenced (First);
      end Send_Twice;

      procedure Receive_Twice
        (Box : in out Mailbox; Item : out Channel_Words) is
         Old_Item         : Channel_Words;
         Old_Fresh, Fresh : Boolean;
      begin
         Receive (Box, Old_Item, Old_Fresh);
         pragma Assert (not Is_Fresh (Box));
         Receive (Box, Item, Fresh);
         pragma Assert (not Fresh);
         pragma Unreferenced (Old_Item, Old_Fresh);
      end Receive_Twice;

   end Mailboxes;

   package body Scheduling is

      procedure No_Task_Is_Woken (S : Scheduler; Now : Clock_Tick) is null;

      procedure The_Caller_Runs_On (S : Scheduler) is null;

      procedure The_Caller_Is_Kept (S : Scheduler) is null;

      procedure No_Task_Is_Late (S : Scheduler) is null;

   end Scheduling;

end Canaries.Kernel;
