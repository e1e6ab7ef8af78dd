--  SPDX-License-Identifier: Apache-2.0

with Theorems.Seals;
with URV.Codecs;       use URV.Codecs;
with URV.Plain_Blocks; use URV.Plain_Blocks;
with URV.Seal_Blocks;  use URV.Seal_Blocks;
with URV.Seals;        use URV.Seals;
with URV.Sessions;     use URV.Sessions;

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
     (Data   : Block_Words;
      Number : Counter;
      Echo   : Counter;
      Inside : Session)
   with
     Global => null,
     Post   =>
       (for all Which in Word_Place =>
          (if Which <= Uplink_Words
           then Unpacked (Sealed (Data, Ground, Number, Echo, Inside), Ground)
             (Which) = Theorems.Seals.Carried (Data, Ground, Which)));

   procedure All_Words_Come_Through
     (Data   : Block_Words;
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
               then Unpacked
                 (Sealed (Data, Ground, Number, Echo, Inside), Ground)
                 (Which) = Theorems.Seals.Carried (Data, Ground, Which)));
      end loop;
   end All_Words_Come_Through;

   --  Equal blocks have equal words.
   procedure Same_Words (One, Other : Block_Data)
   with
     Global => null,
     Pre    => One = Other,
     Post   =>
       (for all Which in Word_Place =>
          (if Which <= Uplink_Words
           then Unpacked (One, Ground) (Which) =
             Unpacked (Other, Ground) (Which)));

   procedure Same_Words (One, Other : Block_Data) is
   begin
      pragma Assert
        (for all Which in Word_Place =>
           (if Which <= Uplink_Words
            then Field_At (One, Which) = Field_At (Other, Which)));
   end Same_Words;

   procedure Same_Plain_Words (One, Other : Block_Data)
   with
     Global => null,
     Pre    => One = Other,
     Post   =>
       (for all Which in Word_Place =>
          Decode (One, Uplink_Words) (Which) =
            Decode (Other, Uplink_Words) (Which));

   procedure Same_Plain_Words (One, Other : Block_Data) is
   begin
      pragma Assert
        (for all Where in Byte_Index => One (Where) = Other (Where));
   end Same_Plain_Words;

   --  A received message.
   procedure Received_Is_Carried
     (Message : Uplink_Buffer; Words : Block_Words; Format : Format_Number)
   with
     Global => null,
     Pre    =>
       (for all Which in Word_Place =>
          (if Which <= Uplink_Words
           then Words (Which) =
             (if Format = 1 then Uplink.Words_Of (Message) (Which)
              else Theorems.Seals.Carried
                (Uplink.Words_Of (Message), Ground, Which)))),
     Post   =>
       (for all Name in Command_Item =>
          Uplink.Buffer_Of (Words) (Name) = Carried (Message (Name), Format))
       and then
         Uplink.Buffer_Of (Words) (Error_Status) =
           (if Format = 1 then Message (Error_Status)
            else Message (Error_Status) mod 16);

   procedure Received_Is_Carried
     (Message : Uplink_Buffer; Words : Block_Words; Format : Format_Number)
   is
      Sent : constant Block_Words := Uplink.Words_Of (Message);
   begin
      pragma Assert
        (for all Name in Uplink_Item =>
           Sent (Uplink.Place (Name)) = Message (Name));
      pragma Assert
        (for all Name in Uplink_Item =>
           Words (Uplink.Place (Name)) =
             (if Format = 1 then Sent (Uplink.Place (Name))
              else Theorems.Seals.Carried
                (Sent, Ground, Uplink.Place (Name))));
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
      Sent   : constant Block_Words := Uplink.Words_Of (Message);
      Line   : Block_Data;
      Was    : constant Seal := Opening;
      Words  : Block_Words;
   begin
      Close (Sending, Sent, Line);
      pragma Assert (Before.Format = Format and then Before.Role = Ground);
      pragma Assert (Line = Closed (Before, Sent));
      Open (Opening, Line, True, Words, Result);
      pragma Assert
        (Opening.Format = Format and then Opening.Role = Aircraft);
      Kept := URV.Uplink_Input.Next (Kept, Result, Words);

      if Result in Taken then
         if Format = 1 then
            pragma Assert (Line = Encode (Sent, Uplink_Words));
            pragma Assert (Words = Words_In (Was, Line));
            pragma Assert
              (for all Which in Word_Place =>
                 Words (Which) = Decode (Line, Uplink_Words) (Which));
            Same_Plain_Words (Line, Encode (Sent, Uplink_Words));
            Round_Trip (Sent, Uplink_Words);
            pragma Assert
              (for all Which in Word_Place =>
                 (if Which <= Uplink_Words
                  then Words (Which) = Sent (Which)));
         else
            pragma Assert (Mark_Of (Line) = Sealed_Mark);
            A_Hello_Has_Its_Mark (Before);
            pragma Assert (not Sends_Hello (Before));
            pragma Assert
              (Line =
                 Sealed
                   (Sent, Ground, Before.Active.Age,
                    Echo_Now (Before.Active), Before.Active));
            pragma Assert (Words = Words_In (Was, Line));
            pragma Assert
              (for all Which in Word_Place =>
                 Words (Which) = Unpacked (Line, Ground) (Which));
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
                  then Words (Which) =
                    Theorems.Seals.Carried (Sent, Ground, Which)));
         end if;
         Received_Is_Carried (Message, Words, Format);
         pragma Assert (Kept.Buffer = Uplink.Buffer_Of (Words));
         Same_Flags (Kept.Buffer, Message);
         Same_Servos (Kept.Buffer, Message, Format);
      end if;
   end A_Taken_Message_Was_Sent;

end Theorems.Sealed_Commands;
