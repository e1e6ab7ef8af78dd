--  SPDX-License-Identifier: Apache-2.0

with Checks;             use Checks;
with Expectations;       use Expectations;
with URVOS;              use URVOS;
with Telemetry;          use Telemetry;
with Telemetry.Checksum;
with Telemetry.Headers;  use Telemetry.Headers;
with Telemetry.Senders;  use Telemetry.Senders;

separate (Link_Suite)
package body Senders_Tests is

   --  The tests, in order.
   procedure Messages;
   procedure Wire_Lengths;

   Lengths : constant array (1 .. 5) of Block_Length :=
     (1, 2, 4, Uplink_Length, Downlink_Length);

   procedure Messages is
      Data   : Block_Data;
      Item   : Sender;
      Output : Byte;
      Sum    : Byte;

      procedure Send (Length : Block_Length);

      procedure Send (Length : Block_Length) is
      begin
         Output := Next_Byte (Item, Data, Length);
         Item := Advanced (Item, Data, Length);
      end Send;
   begin
      for I in Data'Range loop
         Data (I) := 3 * Byte (I) + 1;
      end loop;
      for Length of Lengths loop
         Item := (others => <>);
         Send (Length);
         Expect ("header", Output, Encode ((Telemetry.Headers.Data, Length)));
         Sum := Checksum.Next (Checksum.First_Value, Output);
         for I in 1 .. Length loop
            Send (Length);
            Expect ("byte" & I'Image, Output, Data (I));
            Sum := Checksum.Next (Sum, Output);
         end loop;
         Send (Length);
         Expect ("checksum", Output, Sum);
         Expect_Number
           ("characters", Integer (Item.Sent),
            Integer (Message_Length (Length)));
      end loop;
   end Messages;

   procedure Wire_Lengths is
   begin
      Expect_Number
        ("of an uplink", Integer (Message_Length (Uplink_Length)),
         Uplink_Length + 2);
      Expect_Number
        ("of a downlink", Integer (Message_Length (Downlink_Length)),
         Downlink_Length + 2);
   end Wire_Lengths;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "LNK-3 a data message is its count, data and checksum",
         Messages'Access);
      Add
        (Suite, "D-5 a data message is two characters longer than its data",
         Wire_Lengths'Access);
   end Add_To;

end Senders_Tests;
