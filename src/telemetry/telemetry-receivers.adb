--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Receivers with SPARK_Mode is

   procedure Store_Byte
     (Item         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Length       : Block_Length;
      Data         : Byte;
      Parity_Error : Boolean)
   is
      Was    : constant Receiver    := Item with Ghost;
      Before : constant Buffer_Pair := Pair with Ghost;
   begin
      Item.Received := Item.Received + 1;
      Item.Sum := Checksum.Next (Item.Sum, Data);
      Item.Damaged := Item.Damaged or Parity_Error;
      Pair.Slots (Item.Target).Data (Item.Received) := Data;
      Checksum.Same_Bytes_Same_Sum
        (Data_Header (Length),
         Before.Slots (Item.Target).Data,
         Pair.Slots (Item.Target).Data,
         Was.Received);
      pragma Assert
        (Item.Sum = Checksum.Of_Message
           (Data_Header (Length),
            Pair.Slots (Item.Target).Data,
            Item.Received));
   end Store_Byte;

   procedure Accept_Character
     (Item         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Length       : Block_Length;
      Wants_Data   : Boolean;
      Data         : Byte;
      Parity_Error : Boolean;
      Outcome      : out Event)
   is
      Was    : constant Receiver    := Item;
      Before : constant Buffer_Pair := Pair with Ghost;
   begin
      if Takes_Byte (Item, Length) then
         Outcome := (others => <>);
         Store_Byte (Item, Pair, Length, Data, Parity_Error);
      else
         Outcome := Outcome_Of (Was, Length, Wants_Data, Data, Parity_Error);
         Item := Receiver_After (Was, Pair, Outcome.Kind, Data, Parity_Error);
         pragma Assert
           (if Outcome.Kind = Block_Begun
            then Item.Sum =
              Checksum.Of_Message (Data, Pair.Slots (Item.Target).Data, 0)
              and then Data = Data_Header (Length));
         Pair := Pair_After (Pair, Outcome.Kind);
         pragma Assert
           (if Outcome.Kind in Block_Whole | Block_Spoilt
            then Has_Message (Was)
              and then Item.Received = Length
              and then Item.Target = Was.Target
              and then Item.Sum = Was.Sum
              and then Pair = Before);
         pragma Assert (if Has_Message (Was) then Fits (Item, Pair, Length));
         pragma Assert
           (if Outcome.Kind = Block_Begun then Fits (Item, Pair, Length));
      end if;
   end Accept_Character;

end Telemetry.Receivers;
