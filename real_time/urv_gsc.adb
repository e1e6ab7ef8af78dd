--  The ground station core in real time.

with Ada.Characters.Handling;
with GSC;
with Host.Event_Log;
with Host.Text_Output;   use Host.Text_Output;
with Partitions.Console;
with Partitions.GSC_Node;
with Partitions.Reports; use Partitions.Reports;
with Partitions.Run;

procedure Urv_GSC is

   procedure Put_Results (To : in out Writer; Result : in out Report);

   procedure Put_Events (To : in out Writer);

   function Name (Which : GSC.Task_Name) return String is
     (Ada.Characters.Handling.To_Lower (Which'Image));

   procedure Put_Results (To : in out Writer; Result : in out Report) is
   begin
      Put_Times
        (Result, To, "release_jitter_us",
         Partitions.GSC_Node.Lateness.Summed_Up);
      Begin_Group (Result, To, "cost_us");
      for Which in GSC.Task_Name loop
         Put_Times
           (Result, To, Name (Which),
            Partitions.GSC_Node.Costs (Which).Summed_Up);
      end loop;
      End_Group (Result, To);
      Begin_Group (Result, To, "response_us");
      for Which in GSC.Task_Name loop
         Put_Times
           (Result, To, Name (Which),
            Partitions.GSC_Node.Responses (Which).Summed_Up);
      end loop;
      End_Group (Result, To);
      Put_Log (To, Result, Partitions.GSC_Node.Log);
   end Put_Results;

   procedure Put_Events (To : in out Writer) is
   begin
      Host.Event_Log.Write (To, "gsc", Partitions.GSC_Node.Log, 0);
   end Put_Events;

   procedure Run is new Partitions.Run
     (This         => Host.Ground,
      Load_Script  => Partitions.Console.Load,
      Column_Names => Partitions.Console.Column_Names,
      Switch_On    => Partitions.GSC_Node.Switch_On,
      Put_Results  => Put_Results,
      Put_Events   => Put_Events,
      Overruns     => Partitions.GSC_Node.Overruns,
      Link_Tally   => Partitions.GSC_Node.Link_Tally,
      Pauses       => Partitions.GSC_Node.Pauses,
      Board_Starts => Partitions.GSC_Node.Board_Starts);

begin
   Run;
end Urv_GSC;
