--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Receivers with SPARK_Mode is

   procedure Store_Byte
     (This         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Length       : Block_Length;
      Data         : Byte;
      Parity_Error : Boolean)
   is
      Was    : constant Receiver    := This with Ghost;
      Before : constant Buffer_Pair := Pair with Ghost;
   begin
      This.Received := This.Received + 1;
      This.Sum := Checksum.Next (This.Sum, Data);
      This.Damaged := This.Damaged or Parity_Error;
      --  By name: an index of a slot takes a multiplication.
      if This.Target = First then
         Pair.Slots (First).Data (This.Received) := Data;
      else
         Pair.Slots (Second).Data (This.Received) := Data;
      end if;
      Checksum.Same_Bytes_Same_Sum
        (Data_Header (Length),
         Before.Slots (This.Target).Data,
         Pair.Slots (This.Target).Data,
         Was.Received);
      pragma Assert
        (This.Sum = Checksum.Of_Message
           (Data_Header (Length),
            Pair.Slots (This.Target).Data,
            This.Received));
   end Store_Byte;

   procedure Accept_Character
     (This         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      Outcome      : out Event)
   is
      Was    : constant Receiver    := This with Ghost;
      Before : constant Buffer_Pair := Pair with Ghost;
   begin
      if Takes_Byte (This, Length) then
         Outcome := (others => <>);
         Store_Byte (This, Pair, Length, Data, Parity_Error);
      else
         Outcome := Outcome_Of (This, Length, Wants_Data, Data, Parity_Error);
         case Outcome.Kind is
            when Nothing | Command | Status =>
               null;
            when Lost_Step =>
               This.State := Out_Of_Step;
            when Block_Begun =>
               This :=
                 (State    => In_Data,
                  Target   => To_Fill (Pair),
                  Received => 0,
                  Sum      => Checksum.Next (Checksum.First_Value, Data),
                  Damaged  => False);
               Pair.Slots (This.Target).Busy := True;
               Pair.Slots (This.Target).Full := False;
               pragma Assert
                 (This.Sum = Checksum.Of_Message
                    (Data, Pair.Slots (This.Target).Data, 0)
                  and then Data = Data_Header (Length));
            when Block_Whole =>
               This.State := At_End;
            when Block_Spoilt =>
               This.State := At_End;
               This.Damaged := True;
         end case;
         pragma Assert
           (This = Receiver_After
              (Was, Before, Outcome.Kind, Data, Parity_Error));
         pragma Assert (Pair = Pair_After (Before, Outcome.Kind));
         pragma Assert
           (if Outcome.Kind in Block_Whole | Block_Spoilt
            then Has_Message (Was)
              and then This.Received = Length
              and then This.Target = Was.Target
              and then This.Sum = Was.Sum
              and then Pair = Before);
         pragma Assert (if Has_Message (Was) then Fits (This, Pair, Length));
         pragma Assert
           (if Outcome.Kind = Block_Begun then Fits (This, Pair, Length));
      end if;
   end Accept_Character;

end Telemetry.Receivers;
