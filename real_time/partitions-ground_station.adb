--  SPDX-License-Identifier: Apache-2.0

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Host.Frame_Layout;
with Partitions.Console;
with Partitions.Console_Port;
with Partitions.Orders;
with Partitions.Publisher;
with Partitions.Recorder_Answers;
with Partitions.Reports; use Partitions.Reports;

package body Partitions.Ground_Station is

   procedure Prepare (Chosen : Host.Options.Choices) is
      use Host.Options;
   begin
      if Is_Given (Chosen, Sticks_Option) then
         Console.Load (Value (Chosen, Sticks_Option));
      end if;
      if Is_Given (Chosen, Pilot_Option) then
         Console.Take_Aboard (Value (Chosen, Pilot_Option));
      end if;
      if Is_Given (Chosen, Console_Option) then
         Console_Port.Open (Value (Chosen, Console_Option));
      end if;
      if Is_Given (Chosen, Orders_Option) then
         Orders.Load (Value (Chosen, Orders_Option));
      end if;
      Publisher.Choose (Host.Frame_Layout.Version_Number (Chosen.Packets));
      for Place of Chosen.Publish loop
         exit when Place = Null_Unbounded_String;
         Publisher.Open (To_String (Place));
      end loop;
   end Prepare;

   procedure Publish (Item : Partitions.Rows.Row) is
   begin
      Publisher.Publish (Item);
      Recorder_Answers.Pass_On;
   end Publish;

   procedure Put_Counts
     (Result : in out Partitions.Reports.Report;
      To     : in out Host.Text_Output.Writer) is
   begin
      Put_Field
        (Result, To, "publish_not_sent", Reports.Number (Publisher.Not_Sent));
      Put_Field (Result, To, "orders_sent", Reports.Number (Orders.Sent));
      Begin_Group (Result, To, "console");
      Put_Field (Result, To, "packets", Reports.Number (Console_Port.Taken));
      Put_Field (Result, To, "bad", Reports.Number (Console_Port.Dropped));
      Put_Field (Result, To, "held", Reports.Number (Console.Times_Held));
      Put_Field
        (Result, To, "neutral", Reports.Number (Console.Times_Neutral));
      End_Group (Result, To);
   end Put_Counts;

end Partitions.Ground_Station;
