procedure Partitions.Uninterrupted_Call is
begin
   Hold_Interrupts;
   Call;
   Release_Interrupts;
exception
   when others =>
      Release_Interrupts;
      raise;
end Partitions.Uninterrupted_Call;
