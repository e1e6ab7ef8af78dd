--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Receivers with SPARK_Mode is

   procedure Accept_Character
     (Item         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      Outcome      : out Event)
   is
      Was    : constant Receiver    := Item with Ghost;
      Before : constant Buffer_Pair := Pair with Ghost;
   begin
      case Item.State is
         when At_Start =>
            Outcome := Meaning (Data, Parity_Error, Length, Wants_Data);

            if Outcome.Kind = Block_Begun then
               pragma Assert (Data = Data_Header (Length));
               Item :=
                 (State    => In_Data,
                  Target   => To_Fill (Pair),
                  Received => 0,
                  Sum      => Checksum.Next (Checksum.First_Value, Data),
                  Damaged  => False);
               Pair.Slots (Item.Target).Busy := True;
               Pair.Slots (Item.Target).Full := False;
            elsif Outcome.Kind = Lost_Step then
               Item.State := Out_Of_Step;
            end if;
            pragma Assert
              (Pair = Pair_After (Was, Before, Outcome.Kind, Data));

         when In_Data =>
            Item.Damaged := Item.Damaged or Parity_Error;

            if Item.Received < Length then
               Outcome := (others => <>);
               Item.Received := Item.Received + 1;
               Pair.Slots (Item.Target).Data (Item.Received) := Data;
               Item.Sum := Checksum.Next (Item.Sum, Data);

               Checksum.Same_Bytes_Same_Sum
                 (Data_Header (Length),
                  Before.Slots (Item.Target).Data,
                  Pair.Slots (Item.Target).Data,
                  Item.Received - 1);
               pragma Assert
                 (Item.Sum = Checksum.Of_Message
                    (Data_Header (Length),
                     Pair.Slots (Item.Target).Data,
                     Item.Received));
               pragma Assert
                 (Pair = Pair_After (Was, Before, Outcome.Kind, Data));
            else
               Item.State := At_Start;
               Pair.Slots (Item.Target).Busy := False;

               if not Item.Damaged and then Data = Item.Sum then
                  Outcome := (Kind => Block_Good, others => False);
                  Pair.Slots (Item.Target).Full := True;
                  Pair.Newest := Item.Target;
               else
                  Outcome := (Kind => Block_Bad, others => False);
               end if;
               pragma Assert
                 (Pair = Pair_After (Was, Before, Outcome.Kind, Data));
            end if;

         when Out_Of_Step =>
            Outcome := (others => <>);
      end case;
   end Accept_Character;

   procedure Restart
     (Item : in out Receiver;
      Pair : in out Buffer_Pair)
   is
   begin
      Item.State := At_Start;
      Pair.Slots (First).Busy := False;
      Pair.Slots (Second).Busy := False;
   end Restart;

end Telemetry.Receivers;
