--  The ground station core in real time.

with GSC;
with Partitions.Console;
with Partitions.GSC_Node;
with Partitions.Options;
with Partitions.Reports;
with Partitions.Run;
with Sim.Text_Output;

procedure Urv_GSC is
   procedure Put_Results
     (To     : in out Sim.Text_Output.Writer;
      Report : in out Partitions.Reports.Report) is null;
   procedure Put_Events (To     : in out Sim.Text_Output.Writer) is null;
   procedure Run is new Partitions.Run
     (This         => Partitions.Options.GSC,
      Load_Script  => Partitions.Console.Load,
      Column_Names => Partitions.Console.Column_Names,
      Switch_On    => Partitions.GSC_Node.Switch_On,
      Put_Results  => Put_Results,
      Put_Events   => Put_Events,
      Overruns     => GSC.Executive.Overruns);
begin
   Run;
end Urv_GSC;
