package body Devices.Shared_AD_Board
  with
    SPARK_Mode,
    Refined_State => (Board => Guarded_Board)
is

   protected Guarded_Board is

      procedure Initialise;

      procedure Start (Channel : Channel_Number);

      procedure Take_Start
        (Wanted  : out Boolean;
         Channel : out Channel_Number);

      procedure Finish (Value : Word; Interrupt : out Boolean);

      function Snapshot return Registers;

   private
      Contents : Registers;
   end Guarded_Board;

   protected body Guarded_Board is

      procedure Initialise is
      begin
         Contents := Initialised (Contents);
      end Initialise;

      procedure Start (Channel : Channel_Number) is
      begin
         Contents := Started (Contents, Channel);
      end Start;

      procedure Take_Start
        (Wanted  : out Boolean;
         Channel : out Channel_Number)
      is
      begin
         Wanted := Contents.Doing = Start_Wanted;
         Channel := Contents.Channel;
         Contents := Begun (Contents);
      end Take_Start;

      procedure Finish (Value : Word; Interrupt : out Boolean) is
      begin
         Interrupt :=
           Contents.Doing = Converting and then Contents.Interrupt_Enabled;
         Contents := Finished (Contents, Value);
      end Finish;

      function Snapshot return Registers is (Contents);

   end Guarded_Board;

   procedure Initialise is
   begin
      Guarded_Board.Initialise;
   end Initialise;

   procedure Start (Channel : Channel_Number) is
   begin
      Guarded_Board.Start (Channel);
   end Start;

   procedure Read (Data : out Word) is
      Snapshot : constant Registers := Guarded_Board.Snapshot;
   begin
      Data := Snapshot.Data;
   end Read;

   procedure Take_Start
     (Wanted  : out Boolean;
      Channel : out Channel_Number)
   is
   begin
      Guarded_Board.Take_Start (Wanted, Channel);
   end Take_Start;

   procedure Finish (Value : Word; Interrupt : out Boolean) is
   begin
      Guarded_Board.Finish (Value, Interrupt);
   end Finish;

end Devices.Shared_AD_Board;
