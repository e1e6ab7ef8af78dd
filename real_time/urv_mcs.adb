--  The aircraft's multiprocessor control system in real time.

with MCS;
with Partitions.Aircraft;
with Partitions.MCS_Node;
with Partitions.Options;
with Partitions.Reports;
with Partitions.Run;
with Sim.Text_Output;

procedure Urv_MCS is
   procedure Put_Results
     (To     : in out Sim.Text_Output.Writer;
      Report : in out Partitions.Reports.Report) is null;
   procedure Put_Events (To     : in out Sim.Text_Output.Writer) is null;
   procedure Run is new Partitions.Run
     (This         => Partitions.Options.MCS,
      Load_Script  => Partitions.Aircraft.Load,
      Column_Names => Partitions.Aircraft.Column_Names,
      Switch_On    => Partitions.MCS_Node.Switch_On,
      Put_Results  => Put_Results,
      Put_Events   => Put_Events,
      Overruns     => MCS.Executive.Overruns);
begin
   Run;
end Urv_MCS;
