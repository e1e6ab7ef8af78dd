--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Turns.Changes with SPARK_Mode is

   --  Counts an event that has happened.
   procedure Count_Up (Number : in out Count)
   with
     Inline,
     Global => null,
     Post   => Number = Incremented (Number'Old);

   procedure Count_Up (Number : in out Count) is
   begin
      Number := Incremented (Number);
   end Count_Up;

   procedure Reset_Control (This : in out Control; Blocks : Buffer_Pair) is
   begin
      if Has_Message (This.Receiver) then
         Count_Up (This.Tally.Bad);
      end if;
      if Is_Scrapped (Blocks, This.Sender.Source, Delivery_In_Reset (This))
      then
         Count_Up (This.Tally.Scrapped);
      end if;
      if This.State = Idling then
         This.State := Ready;
      else
         Count_Up (This.Tally.Resets);
         This.State := After_Break (This);
      end if;
      This.Receiver.State := At_Start;
      This.Silence := 0;
      This.In_A_Row := 0;
   end Reset_Control;

   procedure Inform
     (This    : in out Control;
      Trigger : Event;
      Block   : Delivery;
      Blocks  : Buffer_Pair) is
   begin
      if Trigger.Kind = Lost_Step and then This.Role = Ground then
         Reset_Control (This, Blocks);
      else
         if Trigger.Kind = Receivers.Status
           and then This.Role = Ground
           and then This.State = Awaiting_Status
         then
            This.Downlink_Turns :=
              (if Trigger.Wants_Downlink then Turn_Count'Last else 0);
         end if;
         if Trigger.Kind = Command and then This.Role = Aircraft then
            This.Clear_To_Send := True;
         end if;
         if Block /= Open then
            if Is_Scrapped (Blocks, This.Sender.Source, Block) then
               Count_Up (This.Tally.Scrapped);
            end if;
            This.State := Ready;
         end if;
         This.Silence := 0;
      end if;
   end Inform;

   procedure Judge_Message (This : in out Control; Received : Buffer_Pair) is
   begin
      if This.Receiver.Damaged then
         This.Owed := Bad;
         Count_Up (This.Tally.Bad);
      else
         This.Owed := Good;
         This.Downlink_Turns := 0;
         Count_Up (This.Messages);
         Count_Up (This.Tally.Received);
         if Both_Full (Received) then
            Count_Up (This.Tally.Not_Taken);
         end if;
      end if;
      This.Receiver.State := At_Start;
      This.State := Ready;
      This.Silence := 0;
   end Judge_Message;

   procedure Prepare
     (This   : in out Control;
      Blocks : Buffer_Pair;
      Begins : Boolean) is
   begin
      if Begins then
         This.Sender := (Source => Newest_Full (Blocks), others => <>);
         This.State := Sending;
         This.Clear_To_Send := False;
         if This.Role = Ground then
            This.In_A_Row := This.In_A_Row + 1;
         end if;
         Count_Up (This.Tally.Sent);
         if Both_Full (Blocks) then
            Count_Up (This.Tally.Cleared);
         end if;
      elsif Is_At_Rest (This) then
         if This.In_A_Row > 0 and then This.Downlink_Turns = 0 then
            This.State := Idling;
            This.Silence := 0;
         else
            This.Clear_To_Send := False;
         end if;
      end if;
   end Prepare;

   procedure Note_Spoken (This : in out Control; Blocks : Buffer_Pair) is
      Commands : constant Boolean := May_Command (This);
   begin
      --  The silence begins when this board's last character has left.
      if This.Line_Taken then
         This.Silence := 0;
      end if;
      This.Line_Taken :=
        This.Owed /= None or else This.State = Sending or else Commands;
      This.Owed := None;
      if Commands then
         This.State := Awaiting_Data;
         This.Downlink_Turns := This.Downlink_Turns - 1;
      elsif This.State = Sending then
         This.Sender :=
           Advanced
             (This.Sender, Blocks.Slots (This.Sender.Source).Data,
              This.Transmit_Length);
         if This.Sender.Sent = Message_Length (This.Transmit_Length) then
            This.State := Awaiting_Status;
         end if;
      end if;
   end Note_Spoken;

end Telemetry.Turns.Changes;
