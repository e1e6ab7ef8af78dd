with Checks;       use Checks;
with Expect_Value;
with Expectations; use Expectations;
with URVOS;        use URVOS;
with URV.AD_Scans; use URV.AD_Scans;
with URV.Buffers;  use URV.Buffers;

package body Scan_Tests is

   procedure Expect is new Expect_Value (Next_Step);

   --  The tests, in order.
   procedure Whole_Scan;
   procedure Interrupt_After_Scan;
   procedure Restart_Within_Scan;

   --  A word that tells its channel.
   function Word_Of (Which : Channel) return Word is
     (16#0A00# + Word (Which));

   procedure Whole_Scan is
      Item : Scan := Restarted ((others => <>));
      Next : Next_Step;
   begin
      for Which in Channel loop
         Store (Item, Word_Of (Which), Next);
         Expect
           ("after channel" & Which'Image, Next,
            (if Which = Channel'Last then Send_Words else Start_Channel));
      end loop;
      for Which in Channel loop
         Expect
           ("channel" & Which'Image, Item.Words (Which), Word_Of (Which));
      end loop;
   end Whole_Scan;

   procedure Interrupt_After_Scan is
      Item   : Scan := Restarted ((others => <>));
      Before : Scan;
      Next   : Next_Step;
   begin
      for Which in Channel loop
         Store (Item, Word_Of (Which), Next);
      end loop;
      Before := Item;
      Store (Item, 16#0FFF#, Next);
      Expect ("what to do", Next, Ignore);
      Expect ("the scan is as it was", Item = Before, True);
   end Interrupt_After_Scan;

   procedure Restart_Within_Scan is
      Item : Scan := Restarted ((others => <>));
      Next : Next_Step;
   begin
      Store (Item, 1, Next);
      Store (Item, 2, Next);
      Item := Restarted (Item);
      Store (Item, 3, Next);
      Expect ("channel 0, again", Item.Words (0), 3);
      Expect ("channel 1, before", Item.Words (1), 2);
      Expect ("what to do", Next, Start_Channel);
   end Restart_Within_Scan;

   procedure Add_To (Suite : not null AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "ADI-1 a scan stores 32 channels, then sends",
           Whole_Scan'Access);
      Add (Suite, "ADI-1 an interrupt outside a scan stores nothing",
           Interrupt_After_Scan'Access);
      Add (Suite, "AD-1 a scan begun again begins with channel 0",
           Restart_Within_Scan'Access);
   end Add_To;

end Scan_Tests;
