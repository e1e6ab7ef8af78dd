--  SPDX-License-Identifier: Apache-2.0

with Theorems.Seals;
with URV.Codecs;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Seals;       use URV.Seals;
with URV.Sessions;    use URV.Sessions;

package body Theorems.Sealed_Commands with SPARK_Mode is

   --  A hello keeps its mark under a tag.
   procedure A_Hello_Has_Its_Mark (Sending : Seal)
   with
     Global => null,
     Post   => Mark_Of (Closed_Hello (Sending)) = Hello_Mark;

   procedure A_Hello_Has_Its_Mark (Sending : Seal) is
   begin
      pragma Assert (Own_Hello (Sending) (1) = Hello_Mark);
      pragma Assert (Closed_Hello (Sending) (1) = Hello_Mark);
   end A_Hello_Has_Its_Mark;

   --  All words of a sealed block.
   procedure All_Words_Come_Through
     (Data   : Block_Data;
      Number : Counter;
      Echo   : Counter;
      Inside : Session)
   with
     Global => null,
     Post   =>
       (for all Which in Word_Place =>
          (if Which <= Uplink_Words
           then Word_At
             (Unpacked (Sealed (Data, Ground, Number, Echo, Inside), Ground),
              Which) =
             Theorems.Seals.Carried (Data, Ground, Which)));

   procedure All_Words_Come_Through
     (Data   : Block_Data;
      Number : Counter;
      Echo   : Counter;
      Inside : Session)
   is
   begin
      for Last in Word_Place range 1 .. Uplink_Words loop
         Theorems.Seals.Words_Come_Through
           (Data, Ground, Number, Echo, Inside, Last);
         pragma Loop_Invariant
           (for all Which in Word_Place =>
              (if Which <= Last
               then Word_At
                 (Unpacked
                    (Sealed (Data, Ground, Number, Echo, Inside), Ground),
                  Which) =
                 Theorems.Seals.Carried (Data, Ground, Which)));
      end loop;
   end All_Words_Come_Through;

   --  The place of a word in a block.
   function Place_Of (Name : Uplink_Item) return Word_Place is
     (Uplink_Item'Pos (Name) + 1)
   with
     Global => null,
     Post   => Place_Of'Result <= Uplink_Words;

   --  Equal blocks have equal words.
   procedure Same_Words (One, Other : Block_Data)
   with
     Global => null,
     Pre    => One = Other,
     Post   =>
       (for all Which in Word_Place =>
          (if Which <= Uplink_Words
           then Word_At (Unpacked (One, Ground), Which) =
             Word_At (Unpacked (Other, Ground), Which)));

   procedure Same_Words (One, Other : Block_Data) is
   begin
      pragma Assert
        (for all Which in Word_Place =>
           (if Which <= Uplink_Words
            then Field_At (One, Which) = Field_At (Other, Which)));
   end Same_Words;

   --  A received message.
   procedure Received_Is_Carried
     (Message : Uplink_Buffer; Block : Block_Data; Format : Format_Number)
   with
     Global => null,
     Pre    =>
       (for all Which in Word_Place =>
          (if Which <= Uplink_Words
           then Word_At (Block, Which) =
             (if Format = 1
              then Word_At (URV.Codecs.Uplink.Encode (Message), Which)
              else Theorems.Seals.Carried
                (URV.Codecs.Uplink.Encode (Message), Ground, Which)))),
     Post   =>
       (for all Name in Command_Item =>
          URV.Codecs.Uplink.Decode (Block) (Name) =
            Carried (Message (Name), Format))
       and then
         URV.Codecs.Uplink.Decode (Block) (Error_Status) =
           (if Format = 1 then Message (Error_Status)
            else Message (Error_Status) mod 16);

   procedure Received_Is_Carried
     (Message : Uplink_Buffer; Block : Block_Data; Format : Format_Number)
   is
      Sent : constant Block_Data := URV.Codecs.Uplink.Encode (Message);
   begin
      URV.Codecs.Uplink.Round_Trip (Message);
      pragma Assert
        (for all Name in Uplink_Item =>
           Word_At (Sent, Place_Of (Name)) = Message (Name));
      pragma Assert
        (for all Name in Uplink_Item =>
           Word_At (Block, Place_Of (Name)) =
             (if Format = 1 then Word_At (Sent, Place_Of (Name))
              else Theorems.Seals.Carried (Sent, Ground, Place_Of (Name))));
      pragma Assert
        (for all Name in Uplink_Item =>
           URV.Codecs.Uplink.Decode (Block) (Name) =
             Word_At (Block, Place_Of (Name)));
   end Received_Is_Carried;

   --  The servos' words are the same.
   procedure Same_Servos (One, Other : Uplink_Buffer; Format : Format_Number)
   with
     Global => null,
     Pre    =>
       (for all Name in Command_Item =>
          One (Name) = Carried (Other (Name), Format)),
     Post   =>
       (for all Name in PWM_Item =>
          Transform (One) (Name) = Transform (Other) (Name));

   procedure Same_Servos (One, Other : Uplink_Buffer; Format : Format_Number)
   is
      pragma Unreferenced (Format);
   begin
      pragma Assert
        (for all Name in Command_Item =>
           URV.PWM_Transform.Clipped (One (Name)) =
             URV.PWM_Transform.Clipped (Other (Name)));
      pragma Assert
        (for all Name in Switch_Item =>
           Is_On (One (Name)) = Is_On (Other (Name)));
      pragma Assert (Packed_Switches (One) = Packed_Switches (Other));
      pragma Assert (Flap_Command (One) = Flap_Command (Other));
   end Same_Servos;

   --  The flags are in the four bits that format 2 carries.
   procedure Same_Flags (One, Other : Uplink_Buffer)
   with
     Global => null,
     Pre    =>
       One (Error_Status) in
         Other (Error_Status) | Other (Error_Status) mod 16,
     Post   =>
       Is_Old (One) = Is_Old (Other)
       and then Is_Other_Kind (One) = Is_Other_Kind (Other);

   procedure Same_Flags (One, Other : Uplink_Buffer) is null;

   procedure A_Taken_Message_Was_Sent
     (Message : Uplink_Buffer;
      Sending : in out Seal;
      Opening : in out Seal;
      Kept    : in out Kept_Message;
      Result  : out Outcome)
   is
      Format : constant Format_Number := Opening.Format;
      Before : constant Seal := Renewed (Sending);
      Sent   : constant Block_Data := URV.Codecs.Uplink.Encode (Message);
      Data   : Block_Data := Sent;
      Line   : Block_Data;
   begin
      Close (Sending, Data);
      Line := Data;
      pragma Assert (Before.Format = Format and then Before.Role = Ground);
      pragma Assert (Line = Closed (Before, Sent));
      Open (Opening, Data, True, Result);
      pragma Assert
        (Opening.Format = Format and then Opening.Role = Aircraft);
      Kept := URV.Uplink_Input.Next (Kept, Result, Data);

      if Result in Taken then
         if Format = 1 then
            pragma Assert (Line = Sent);
            pragma Assert (Data = Sent);
            pragma Assert
              (for all Which in Word_Place =>
                 Word_At (Data, Which) = Word_At (Sent, Which));
         else
            pragma Assert (Mark_Of (Line) = Sealed_Mark);
            A_Hello_Has_Its_Mark (Before);
            pragma Assert (not Sends_Hello (Before));
            pragma Assert
              (Line =
                 Sealed
                   (Sent, Ground, Before.Active.Age,
                    Echo_Now (Before.Active), Before.Active));
            pragma Assert (Data = Unpacked (Line, Ground));
            All_Words_Come_Through
              (Sent, Before.Active.Age, Echo_Now (Before.Active),
               Before.Active);
            Same_Words
              (Line,
               Sealed
                 (Sent, Ground, Before.Active.Age, Echo_Now (Before.Active),
                  Before.Active));
            pragma Assert
              (for all Which in Word_Place =>
                 (if Which <= Uplink_Words
                  then Word_At (Data, Which) =
                    Word_At (Unpacked (Line, Ground), Which)));
            pragma Assert
              (for all Which in Word_Place =>
                 (if Which <= Uplink_Words
                  then Word_At (Data, Which) =
                    Theorems.Seals.Carried (Sent, Ground, Which)));
         end if;
         Received_Is_Carried (Message, Data, Format);
         pragma Assert (Kept.Buffer = URV.Codecs.Uplink.Decode (Data));
         Same_Flags (Kept.Buffer, Message);
         Same_Servos (Kept.Buffer, Message, Format);
      end if;
   end A_Taken_Message_Was_Sent;

end Theorems.Sealed_Commands;
