--  SPDX-License-Identifier: Apache-2.0

with Theorems.Safety.Lemmas; use Theorems.Safety.Lemmas;
with URV.AD_Steps;           use URV.AD_Steps;
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

   --  AD's image is sent.
   procedure Hand_On
     (Item : in out Ground_Way; Scans : Scan_History; Image : AD_Image)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item, Scans)
       and then Image.Words = Held (Scans, Item.ADINT_From)
       and then
         (if Item.ADINT_From = 0 then Image.Error_Status = Stale_Data),
     Post   =>
       Is_Sound (Item, Scans)
       and then Item.Done = Item'Old.Done
       and then Item.ADINT = Item'Old.ADINT
       and then Item.ADINT_From = Item'Old.ADINT_From
       and then Item.Scanning = Item'Old.Scanning
       and then Contents (Item.AD).Error_Status = Image.Error_Status;

   procedure Hand_On
     (Item : in out Ground_Way; Scans : Scan_History; Image : AD_Image)
   is
      Unused_Success : Boolean;
   begin
      Send (Item.AD, Image, Unused_Success);
      Item.AD_From := Item.ADINT_From;
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Hand_On;

   --  The report's schedule, and the fast one.

   procedure Take_Last_Scan (Item : in out Ground_Way; Scans : Scan_History)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   =>
       Is_Sound (Item, Scans)
       and then Item.Done = Item'Old.Done
       and then
         (if not Is_Fresh (Item'Old.ADINT)
          then Contents (Item.AD).Error_Status = Stale_Data);

   procedure Take_Last_Scan (Item : in out Ground_Way; Scans : Scan_History)
   is
      Words : Channel_Words;
      Fresh : Boolean;
   begin
      Receive (Item.ADINT, Words, Fresh);
      pragma Assert (Words = Held (Scans, Item.ADINT_From));
      pragma Assert (Places_Are_Sound (Item, Scans));
      Hand_On (Item, Scans, Last_Image (Words, Fresh));
   end Take_Last_Scan;

   procedure Follow_Scans
     (Item : in out Ground_Way; Scans : Scan_History; Got : AD_Inputs)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans),
     Post   =>
       Is_Sound (Item, Scans)
       and then Item.Done = Item'Old.Done
       and then
         (if not Is_Fresh (Item'Old.ADINT)
            and then Is_Over (Got.Timeout, Got.Time)
            and then Item'Old.Scanning.Doing = Scanning
            and then Item'Old.Scanning.Received = 0
          then Contents (Item.AD).Error_Status = Stale_Data);

   procedure Follow_Scans
     (Item : in out Ground_Way; Scans : Scan_History; Got : AD_Inputs)
   is
      Kept         : Progress := Item.Scanning;
      Unused_Words : Channel_Words;
      Unused_Fresh : Boolean;
      Words        : Channel_Words;
      Fresh        : Boolean;
      Look_Again   : Boolean;
      Chosen       : Action;
   begin
      if Kept.Doing /= Scanning then
         Look (Item.ADINT, Unused_Words, Unused_Fresh);
         pragma Assert
           (Contents (Item.ADINT) = Held (Scans, Item.ADINT_From));
         Item.Scanning := Scan_Begun (Got.Time);
         pragma Assert (Places_Are_Sound (Item, Scans));
         return;
      end if;

      --  RECV with a wait: the last look is a Receive.
      Kept.Timeout := Got.Timeout;
      if Is_Over (Kept.Timeout, Got.Time) then
         Receive (Item.ADINT, Words, Fresh);
         Look_Again := False;
      else
         Look (Item.ADINT, Words, Fresh);
         Look_Again := not Fresh;
      end if;
      pragma Assert (Words = Held (Scans, Item.ADINT_From));
      pragma Assert (Contents (Item.ADINT) = Held (Scans, Item.ADINT_From));

      Kept := Counted (Kept, Fresh);
      Chosen := Next_Action
        (Kept, Fresh, Look_Again, Got.Most, Got.Time);
      Item.Scanning := After (Kept, Chosen);
      pragma Assert (Places_Are_Sound (Item, Scans));
      if Chosen = Hand_On_Image then
         Hand_On (Item, Scans, Newest_Image (Words, Kept));
      end if;
   end Follow_Scans;

   procedure Run_AD
     (Item : in out Ground_Way; Scans : Scan_History; Got : AD_Inputs)
   is
   begin
      case Got.Schedule is
         when Report => Take_Last_Scan (Item, Scans);
         when Fast   => Follow_Scans (Item, Scans, Got);
      end case;
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
           (Data => Encode
              (URV.Codecs.Uplink.Words_Of (Message), URV.Codecs.Uplink.Words),
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

      --  The AD task's initialisation.
      Item.Scanning := (others => <>);
      pragma Assert (Places_Are_Sound (Item, Scans));
   end Start_Ground;

end Theorems.Safety.Ground_Events;
