package body Recorded_Variables is

   procedure Receive (Item : out Message; Fresh : out Boolean) is
   begin
      Received := Received + 1;
      Item     := Given;
      Fresh    := Is_Fresh;
   end Receive;

   procedure Send (Item : Message; Success : out Boolean) is
   begin
      Sent    := Sent + 1;
      Kept    := Item;
      Success := Succeeds;
   end Send;

   procedure Clear is
   begin
      Given    := Neutral;
      Is_Fresh := True;
      Received := 0;
      Kept     := Neutral;
      Succeeds := True;
      Sent     := 0;
   end Clear;

end Recorded_Variables;
