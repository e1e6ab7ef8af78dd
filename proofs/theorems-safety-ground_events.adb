--  SPDX-License-Identifier: Apache-2.0

with Theorems.Safety.Lemmas; use Theorems.Safety.Lemmas;
with URV.GDCOUT_Steps;

package body Theorems.Safety.Ground_Events with SPARK_Mode is

   procedure End_Scan (Item : in out Ground_Way; Scans : Scan_History) is
      Unused_Success : Boolean;
   begin
      if Item.Done < Scan_Count'Last then
         Item.Done := Item.Done + 1;
         Send (Item.ADINT, Scans (Item.Done), Unused_Success);
         Item.ADINT_From := Item.Done;
         pragma Assert
           (Contents (Item.ADINT) = Held (Scans, Item.ADINT_From));
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans));
   end End_Scan;

   procedure Discard_Scan (Item : in out Ground_Way; Scans : Scan_History) is
      Unused_Words : Channel_Words;
      Unused_Fresh : Boolean;
   begin
      Look (Item.ADINT, Unused_Words, Unused_Fresh);
      pragma Assert (Contents (Item.ADINT) = Held (Scans, Item.ADINT_From));
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Discard_Scan;

   procedure Run_AD (Item : in out Ground_Way; Scans : Scan_History) is
      Words          : Channel_Words;
      Fresh          : Boolean;
      Unused_Success : Boolean;
   begin
      Receive (Item.ADINT, Words, Fresh);
      pragma Assert (Words = Held (Scans, Item.ADINT_From));
      Send (Item.AD, Stamped (Words, Fresh), Unused_Success);
      Item.AD_From := Item.ADINT_From;
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Run_AD;

   procedure Run_GDCOUT
     (Item       : in out Ground_Way;
      Scans      : Scan_History;
      Bits       : Word;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean)
   is
      Image          : AD_Image;
      Fresh          : Boolean;
      Unused_Success : Boolean;
      Message        : Uplink_Buffer;
   begin
      Receive (Item.AD, Image, Fresh);
      pragma Assert (Is_Of (To_Uplink (Image), Scans, Item.AD_From));
      Marked_Is_Of (To_Uplink (Image), Bits, Scans, Item.AD_From);
      Message := URV.GDCOUT_Steps.Message_Of
        (Image, Fresh, Stick_Codes, Bits);
      pragma Assert (Is_Of (Message, Scans, Item.AD_From));
      Message := URV.GDCOUT_Steps.For_Link (Message, Order, Is_Ordered);
      Send (Item.TELOUT, Message, Unused_Success);
      Item.TELOUT_From := Item.AD_From;
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Run_GDCOUT;

   procedure Run_TELOUT
     (Item  : in out Ground_Way;
      Line  : in out Line_Way;
      Scans : Scan_History)
   is
      Message        : Uplink_Buffer;
      Fresh          : Boolean;
   begin
      Receive (Item.TELOUT, Message, Fresh);
      pragma Assert (Is_Sent (Message, Scans, Item.TELOUT_From));
      if Fresh and then Line.Given < Block_Count'Last then
         URV.Codecs.Uplink.Round_Trip (Message);
         Line.Given := Line.Given + 1;
         Line.Blocks (Line.Given) :=
           (Data => URV.Codecs.Uplink.Encode (Message),
            From => Item.TELOUT_From);
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans));
      pragma Assert (Blocks_Are_Sound (Line, Scans, Item.Done));
   end Run_TELOUT;

   procedure Start_Ground
     (Item : in out Ground_Way; Scans : Scan_History; Cold : Boolean)
   is
   begin
      if Cold then
         Item.ADINT := Empty_Mailbox;
         Item.ADINT_From := 0;
         Item.AD := Empty_Mailbox;
         Item.AD_From := 0;
         Item.TELOUT := Empty_Mailbox;
         Item.TELOUT_From := 0;
         pragma Assert (Is_Of (Neutral_Uplink, Scans, 0));
      else
         Item.ADINT := Restarted (Item.ADINT);
         Item.AD := Restarted (Item.AD);
         Item.TELOUT := Restarted (Item.TELOUT);
      end if;
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Start_Ground;

end Theorems.Safety.Ground_Events;
