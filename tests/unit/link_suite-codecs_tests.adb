--  SPDX-License-Identifier: Apache-2.0

with Checks;         use Checks;
with Expectations;   use Expectations;
with Plain_Messages; use Plain_Messages;
with URVOS;          use URVOS;
with Telemetry;      use Telemetry;
with URV.Buffers;    use URV.Buffers;
with URV.Codecs;     use URV.Codecs;
with URV.Plain_Blocks;
with URV.Routing;    use URV.Routing;
with URV.Seal_Blocks;
with URV.Spare_Bits; use URV.Spare_Bits;
with URV.Word_Codecs;

separate (Link_Suite)
package body Codecs_Tests is

   --  The tests, in order.
   procedure Wire_Lengths;
   procedure Uplink_Bytes;
   procedure Downlink_Bytes;
   procedure Part_Of_A_List;
   procedure Round_Trips;
   procedure Image_Uplink;
   procedure Image_Downlink;
   procedure Stamps;
   procedure Out_Of_Range;
   procedure Passed_On_Whole;
   procedure Each_Bit_Of_A_Frame;

   --  An image whose words all differ. Channel n holds 100h + n.
   function Numbered_Image (Error : Word) return AD_Image;

   function Numbered_Image (Error : Word) return AD_Image is
      Result : AD_Image := Neutral_Stick_Image;
   begin
      for Number in Channel loop
         Result.Words (Number) := 16#100# + Word (Number);
      end loop;
      Result.Error_Status := Error;
      return Result;
   end Numbered_Image;

   procedure Wire_Lengths is
   begin
      Expect_Number
        ("bytes up", Integer (Uplink.Block_Length), Uplink_Length);
      Expect_Number
        ("bytes down", Integer (Downlink.Block_Length), Downlink_Length);
   end Wire_Lengths;

   procedure Uplink_Bytes is
      Buffer : Uplink_Buffer;
      Block  : Block_Data;
   begin
      --  Word n is 1n2n in hexadecimal: its high byte comes first.
      for Item in Uplink_Item loop
         Buffer (Item) :=
           16#1020# + 16#101# * Word (Uplink_Item'Pos (Item));
      end loop;
      Block := Block_Of (Buffer);
      for I in Byte range 0 .. Uplink_Length / 2 - 1 loop
         Expect
           ("high byte" & I'Image, Block (2 * Byte_Index (I + 1) - 1),
            16#10# + I);
         Expect
           ("low byte" & I'Image, Block (2 * Byte_Index (I + 1)), 16#20# + I);
      end loop;
      for I in Uplink.Block_Length + 1 .. Byte_Index'Last loop
         Expect ("unused byte", Block (I), 0);
      end loop;
   end Uplink_Bytes;

   procedure Downlink_Bytes is
      Buffer : Downlink_Buffer;
      Block  : Block_Data;
   begin
      for Item in Downlink_Item loop
         Buffer (Item) :=
           16#1020# + 16#101# * Word (Downlink_Item'Pos (Item));
      end loop;
      Block := Block_Of (Buffer);
      for I in Byte range 0 .. Downlink_Length / 2 - 1 loop
         Expect
           ("high byte" & I'Image, Block (2 * Byte_Index (I + 1) - 1),
            16#10# + I);
         Expect
           ("low byte" & I'Image, Block (2 * Byte_Index (I + 1)), 16#20# + I);
      end loop;
   end Downlink_Bytes;

   subtype Switch_Part is Uplink_Item range Switch_1 .. Switch_3;
   type Switch_Words is array (Switch_Part) of Word;
   package Switch_Codec is new URV.Word_Codecs (Switch_Part, Switch_Words);

   procedure Part_Of_A_List is
      Block : constant Block_Data :=
        URV.Plain_Blocks.Encode
          (Switch_Codec.Words_Of ((16#102#, 16#304#, 16#506#)),
           Switch_Codec.Words);
   begin
      Expect_Number ("bytes", Integer (Switch_Codec.Block_Length), 6);
      for I in Byte_Index range 1 .. 6 loop
         Expect ("byte" & I'Image, Block (I), Byte (I));
      end loop;
      Expect ("byte behind", Block (7), 0);
   end Part_Of_A_List;

   procedure Round_Trips is
      Up        : Uplink_Buffer   := (others => 0);
      Up_Back   : Uplink_Buffer;
      Down      : Downlink_Buffer := (others => 0);
      Down_Back : Downlink_Buffer;
      Filler    : Word := 1;
   begin
      --  Each value of 16 bits, in each word, among changing others.
      for Value in Word loop
         Filler := 25_173 * Filler + 13_849;
         Up := (others => Filler);
         Up (Uplink_Item'Val (Value mod Uplink_Buffer'Length)) := Value;
         Up_Back := Uplink_In (Block_Of (Up));
         for Item in Uplink_Item loop
            Expect ("uplink " & Item'Image, Up_Back (Item), Up (Item));
         end loop;

         Down := (others => Filler);
         Down (Downlink_Item'Val (Value mod Downlink_Buffer'Length)) := Value;
         Down_Back := Downlink_In (Block_Of (Down));
         for Item in Downlink_Item loop
            Expect ("downlink " & Item'Image, Down_Back (Item), Down (Item));
         end loop;
      end loop;
   end Round_Trips;

   procedure Image_Uplink is
      Buffer : constant Uplink_Buffer :=
        To_Uplink (Numbered_Image (Error => 16#ABCD#));
   begin
      for Item in Command_Item loop
         Expect
           (Item'Image, Buffer (Item),
            16#100# + Word (Command_Item'Pos (Item)));
      end loop;
      Expect ("last word", Buffer (Uplink_Item'Last), 16#ABCD#);
   end Image_Uplink;

   procedure Image_Downlink is
      Buffer : constant Downlink_Buffer :=
        To_Downlink (Numbered_Image (Error => 16#ABCD#));
   begin
      for Item in Sensor_Item loop
         Expect
           (Item'Image, Buffer (Item),
            16#100# + Word (Sensor_Item'Pos (Item)));
      end loop;
      Expect ("last word", Buffer (Downlink_Item'Last), 16#ABCD#);
   end Image_Downlink;

   procedure Stamps is
      Image : AD_Image;
   begin
      for Fresh in Boolean loop
         Image := Stamped (Numbered_Image (0).Words, Fresh);
         Expect
           ("error word, fresh is " & Fresh'Image, Image.Error_Status,
            (if Fresh then No_Error else Stale_Data));
         for Number in Channel loop
            Expect
              ("channel" & Number'Image, Image.Words (Number),
               16#100# + Word (Number));
         end loop;
      end loop;
   end Stamps;

   procedure Out_Of_Range is
      Up   : Uplink_Buffer;
      Down : Downlink_Buffer;
   begin
      for Value in Word loop
         Expect
           ("word" & Value'Image & " is out of range",
            Is_Out_Of_Range (Value), Value > 4_095);
      end loop;

      Expect
        ("any of good commands", Any_Out_Of_Range (Neutral_Uplink), False);
      for Item in Uplink_Item loop
         Up := Neutral_Uplink;
         Up (Item) := 16#1000#;
         Expect
           ("any with " & Item'Image, Any_Out_Of_Range (Up),
            Item /= Error_Status);
         Expect_Number
           ("the first is " & Item'Image,
            Integer (First_Out_Of_Range (Up)),
            (if Item = Error_Status then 0
             else Uplink_Item'Pos (Item) + 1));

         --  The first of several counts.
         Up (Switch_8) := 16#1000#;
         Expect_Number
           ("the first is not switch 8 with " & Item'Image,
            Integer (First_Out_Of_Range (Up)),
            Integer'Min
              (Uplink_Item'Pos (Item), Uplink_Item'Pos (Switch_8)) + 1);
      end loop;

      Expect
        ("any of good sensors", Any_Out_Of_Range (Neutral_Downlink), False);
      for Item in Downlink_Item loop
         Down := Neutral_Downlink;
         Down (Item) := 16#1000#;
         Expect
           ("any with " & Item'Image, Any_Out_Of_Range (Down),
            Item /= Error_Status);
         Expect_Number
           ("the first is " & Item'Image,
            Integer (First_Out_Of_Range (Down)),
            (if Item = Error_Status then 0
             else Downlink_Item'Pos (Item) + 1));
         Down (Altitude) := 16#1000#;
         Expect_Number
           ("the first is not altitude with " & Item'Image,
            Integer (First_Out_Of_Range (Down)),
            Integer'Min
              (Downlink_Item'Pos (Item), Downlink_Item'Pos (Altitude)) + 1);
      end loop;
   end Out_Of_Range;

   procedure Passed_On_Whole is
      Image : AD_Image := Neutral_Stick_Image;
   begin
      Image.Words (0) := 16#FFFF#;
      Image.Words (1) := 16#1000#;
      Expect
        ("roll to the wire and back",
         Uplink_In (Block_Of (To_Uplink (Image))) (Roll), 16#FFFF#);
      Expect
        ("left flap 1 to the wire and back",
         Downlink_In (Block_Of (To_Downlink (Image))) (Left_Flap_1),
         16#1000#);
   end Passed_On_Whole;

   procedure Each_Bit_Of_A_Frame is
      Frame  : Frame_Words;
      Source : Downlink_Buffer;
      Sent   : Downlink_Buffer;
      Found  : Framed_Downlink;

      function Largest (Item : Frame_Item) return Word is
        (if Item in Running_Card | Card_Phase then 15 else 16#FFF#);

      use type URVOS.Byte;
   begin
      --  All values of each word of a frame, with sensors of all 0, all 1,
      --  and others.
      for Item in Frame_Item loop
         for Value in Word range 0 .. Largest (Item) loop
            Frame := [for Each in Frame_Item => Largest (Each) and 16#A5A#];
            Frame (Item) := Value;
            Source :=
              (others =>
                 (case Value mod 3 is
                     when 0      => 0,
                     when 1      => 16#FFF#,
                     when others => Value));
            Source (Error_Status) := 16#F005#;
            Sent := Source;
            Pack (Sent, Frame);
            Found.Words := Downlink_In (Block_Of (Sent));
            Unpack (Found.Words, Found.Frame);
            Expect ("the sensors", Found.Words = Source, True);
            Expect
              (Item'Image & " is" & Value'Image, Found.Frame = Frame, True);
         end loop;
      end loop;
      Expect
        ("no mark of format 2",
         URV.Seal_Blocks.Mark_Of (Block_Of (Sent)) = 16#50#, True);

      --  Places on the wire: word 1 is 5fff, the number is in words 2 to 4.
      Frame := (Frame_Number => 16#123#, Running_Card => 4, Card_Phase => 5,
                Throttle => 16#678#, others => 0);
      Sent := Packed ((others => 16#9999#), Frame);
      Expect ("mark", Sent (Right_Flap_1), 16#5FFF#);
      Expect ("number, high", Sent (Left_Flap_1), 16#1FFF#);
      Expect ("number, middle", Sent (Right_Flap_2), 16#2FFF#);
      Expect ("number, low", Sent (Left_Flap_2), 16#3FFF#);
      Expect ("card", Sent (Right_Aileron), 16#4FFF#);
      Expect ("phase", Sent (Left_Aileron), 16#5FFF#);
      Expect ("throttle, low", Sent (Uplink_Signal_Strength), 16#8FFF#);
      Expect ("flags and fragment", Sent (Error_Status), 16#9999#);

      --  Words without a mark are not changed.
      Sent (Right_Flap_1) := 16#FFFF#;
      Found.Words := Sent;
      Unpack (Found.Words, Found.Frame);
      Expect ("as they are", Found.Words = Sent, True);
      Expect ("no frame", Found.Frame = Unknown_Frame, True);
   end Each_Bit_Of_A_Frame;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "D-3 two bytes a word go up and come down",
         Wire_Lengths'Access);
      Add
        (Suite, "BUF-1 on the wire: in order, high byte first",
         Uplink_Bytes'Access);
      Add
        (Suite, "BUF-2 on the wire: in order, high byte first",
         Downlink_Bytes'Access);
      Add
        (Suite, "BUF-3 a part of a buffer has its first byte first, too",
         Part_Of_A_List'Access);
      Add
        (Suite, "BUF-3 every word comes back from the wire as it was",
         Round_Trips'Access);
      Add
        (Suite, "GDO-1 13 channels and the error word make an uplink",
         Image_Uplink'Access);
      Add
        (Suite, "MDO-1 D-1 sensors and the error word make a downlink",
         Image_Downlink'Access);
      Add
        (Suite, "AD-1 D-15 the error word says whether the scan is fresh",
         Stamps'Access);
      Add
        (Suite, "D-11 words above 0FFFh are told from good ones",
         Out_Of_Range'Access);
      Add
        (Suite, "D-11 words above 0FFFh are passed on unchanged",
         Passed_On_Whole'Access);
      Add
        (Suite, "FTI-12 D-98 a frame's bits arrive and change no sensor",
         Each_Bit_Of_A_Frame'Access);
   end Add_To;

end Codecs_Tests;
