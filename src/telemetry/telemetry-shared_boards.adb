with Telemetry.Guarded_Boards;

package body Telemetry.Shared_Boards
  with
    SPARK_Mode,
    Refined_State => (Shared_Board => Guarded_Board)
is

   Guarded_Board : Guarded_Boards.Guarded_Board
     (Role, Transmit_Length, Receive_Length);

   procedure Take
     (Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean)
   is
   begin
      Guarded_Board.Take (Data, Fresh, Ever_Received);
   end Take;

   procedure Put (Data : Block_Data; Overwrote : out Boolean) is
   begin
      Guarded_Board.Put (Data, Overwrote);
   end Put;

   procedure Clear_Transmit_Half is
   begin
      Guarded_Board.Clear_Transmit_Half;
   end Clear_Transmit_Half;

   procedure Start is
   begin
      Guarded_Board.Start;
   end Start;

   procedure Accept_Character
     (Elapsed      : Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      May_Speak    : out Boolean)
   is
   begin
      Guarded_Board.Accept_Character
        (Elapsed, Data, Parity_Error, May_Speak);
   end Accept_Character;

   procedure Next_Character
     (Elapsed   : Character_Times;
      Send      : out Boolean;
      Data      : out Byte;
      Time_Left : out Character_Times)
   is
   begin
      Guarded_Board.Next_Character (Elapsed, Send, Data, Time_Left);
   end Next_Character;

   procedure Inspect (Tally : out Statistics) is
   begin
      Tally := Guarded_Board.Tally;
   end Inspect;

end Telemetry.Shared_Boards;
