--  The aircraft's control system in real time.

with Ada.Characters.Handling;
with Host.Event_Log;
with Host.Text_Output;   use Host.Text_Output;
with MCS;
with Partitions.Aircraft;
with Partitions.MCS_Node;
with Partitions.Reports; use Partitions.Reports;
with Partitions.Run;

procedure Urv_MCS is

   procedure Put_Results (To : in out Writer; Result : in out Report);

   procedure Put_Events (To : in out Writer);

   function Name (Which : MCS.Task_Name) return String is
     (Ada.Characters.Handling.To_Lower (Which'Image));

   procedure Put_Results (To : in out Writer; Result : in out Report) is
   begin
      Put_Times
        (Result, To, "release_jitter_us",
         Partitions.MCS_Node.Lateness.Summed_Up);
      Begin_Group (Result, To, "cost_us");
      for Which in MCS.Task_Name loop
         Put_Times
           (Result, To, Name (Which),
            Partitions.MCS_Node.Costs (Which).Summed_Up);
      end loop;
      End_Group (Result, To);
      Begin_Group (Result, To, "response_us");
      for Which in MCS.Task_Name loop
         Put_Times
           (Result, To, Name (Which),
            Partitions.MCS_Node.Responses (Which).Summed_Up);
      end loop;
      End_Group (Result, To);
      Put_Log (To, Result, Partitions.MCS_Node.Log);
   end Put_Results;

   procedure Put_Events (To : in out Writer) is
   begin
      Host.Event_Log.Write (To, "mcs", Partitions.MCS_Node.Log, 0);
   end Put_Events;

   procedure Run is new Partitions.Run
     (This         => Host.Aircraft,
      Load_Script  => Partitions.Aircraft.Load,
      Column_Names => Partitions.Aircraft.Column_Names,
      Switch_On    => Partitions.MCS_Node.Switch_On,
      Put_Results  => Put_Results,
      Put_Events   => Put_Events,
      Overruns     => Partitions.MCS_Node.Overruns,
      Link_Tally   => Partitions.MCS_Node.Link_Tally,
      Pauses       => Partitions.MCS_Node.Pauses,
      Board_Starts => Partitions.MCS_Node.Board_Starts);

begin
   Run;
end Urv_MCS;
