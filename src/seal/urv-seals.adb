--  SPDX-License-Identifier: Apache-2.0

with Interfaces; use Interfaces;

package body URV.Seals with SPARK_Mode is

   --  In place: a seal is long, and a frame passes in each frame.
   procedure Grow_Older (Item : in out Session; Frames : Counter)
   with
     Global => null,
     Post   => Item = Kept (Older (Item'Old, Frames));

   procedure Grow_Older (Item : in out Session; Frames : Counter) is
   begin
      Item.Age :=
        (if Frames <= Last_Age - Item.Age then Item.Age + Frames
         else Last_Age);
      if Is_Over (Item) then
         Item := No_Session;
      end if;
   end Grow_Older;

   procedure Pass (This : in out Seal; Frames : Counter) is
      Was : constant Seal := This
      with Ghost;
   begin
      if Frames > 0 and then Sends_Hello (This) then
         This.Turn := Next_Place (To_Answer (This));
      end if;
      This.Silence := Silence_After (This, Frames);
      if This.Role = Aircraft and then This.Silence = Longest_Silence then
         This.Active := No_Session;
      else
         Grow_Older (This.Active, Frames);
      end if;
      for Each in Pending_Place loop
         Grow_Older (This.Pending (Each), Frames);

         pragma Loop_Invariant
           (for all Place in Pending_Place =>
              This.Pending (Place) =
                (if Place <= Each
                 then Kept (Older (Was.Pending (Place), Frames))
                 else Was.Pending (Place)));
         pragma Loop_Invariant
           (This = (This'Loop_Entry with delta Pending => This.Pending));
      end loop;
      pragma Assert (This.Active = After_Frames (Was, Frames).Active);
      pragma Assert
        (for all Each in Pending_Place =>
           This.Pending (Each) = After_Frames (Was, Frames).Pending (Each));
      pragma Assert (This.Pending = After_Frames (Was, Frames).Pending);
      pragma Assert (This.Turn = After_Frames (Was, Frames).Turn);
   end Pass;

   --  A block of the active session, in place.
   procedure Take
     (This : in out Session; Block : Block_Data; Sender : Station)
   with
     Global => null,
     Pre    => Opens (Block, Sender, This),
     Post   => This = With_Newest (This'Old, Block, Sender);

   procedure Add_Tag
     (Block : in out Block_Data; Sender : Station; Item : Unsigned_64)
   with
     Global => null,
     Post   => Block = With_Tag (Block'Old, Sender, Item);

   procedure Take
     (This : in out Session; Block : Block_Data; Sender : Station)
   is
      Number : constant Counter := Number_Of (Block, Sender, This);
      Echo   : constant Counter := Echo_Of (Block, Sender, This);
   begin
      if Echo > 0 and then Echo >= By_Reference (This, Number) then
         This :=
           (This with delta
              Newest     => Number,
              Taken_At   => This.Age,
              Reference  => Number,
              Not_Before => Echo);
      else
         This.Newest := Number;
         This.Taken_At := This.Age;
      end if;
   end Take;

   procedure Add_Tag
     (Block : in out Block_Data; Sender : Station; Item : Unsigned_64)
   is
      Last : constant Byte_Index := Covered (Sender);
   begin
      Block (Last + 1) := Tag_Byte (Item, 1);
      Block (Last + 2) := Tag_Byte (Item, 2);
      Block (Last + 3) := Tag_Byte (Item, 3);
      Block (Last + 4) := Tag_Byte (Item, 4);
      Block (Last + 5) := Tag_Byte (Item, 5);
      Block (Last + 6) := Tag_Byte (Item, 6);
      if Sender = Aircraft then
         Block (Last + 7) := Tag_Byte (Item, 7);
         Block (Last + 8) := Tag_Byte (Item, 8);
      end if;
   end Add_Tag;

   procedure Close_Hello (This : Seal; Block : out Block_Data)
   with
     Global => null,
     Post   => Block = Closed_Hello (This);

   procedure Close_Hello (This : Seal; Block : out Block_Data) is
   begin
      Block := Own_Hello (This);
      Add_Tag
        (Block, This.Role,
         Tag_Of
           (Block, This.Role, 0, 0,
            Found_Hello_Key (This, Hello_Number (Block), This.Role)));
   end Close_Hello;

   procedure Open
     (This    : in out Seal;
      Block   : Block_Data;
      Arrived : Boolean;
      Words   : out Block_Words;
      Result  : out Outcome) is
   begin
      Result := Outcome_Of (This, Block, Arrived);
      if Result not in Taken then
         Words := [others => 0];
      elsif This.Format = 1 then
         Words := Decode (Block, Words_Of (Other (This.Role)));
      else
         Words := Unpacked (Block, Other (This.Role));
      end if;
      if This.Format = 2 and then Result = Opened then
         Take (This.Active, Block, Other (This.Role));
         This.In_Doubt := False;
         This.Silence := 0;
      elsif This.Format = 2 and then Result in Opened_New_Session | Hello_Taken
      then
         This := After (This, Block, Result);
      end if;
   end Open;

   procedure Close
     (This : in out Seal; Data : Block_Words; Block : out Block_Data) is
   begin
      if This.Active.Is_Present and then This.Active.Age = Last_Age then
         This := Restarted (This);
      end if;
      if This.Format = 1 then
         Block := Encode (Data, Words_Of (This.Role));
      elsif Sends_Hello (This) then
         Close_Hello (This, Block);
      else
         Block := Packed
           (Data, This.Role, This.Active.Age, Echo_Now (This.Active));
         Add_Tag
           (Block, This.Role,
            Tag_Of
              (Block, This.Role, This.Active.Age, Echo_Now (This.Active),
               Key_Of (This.Active, This.Role)));
      end if;
   end Close;

end URV.Seals;
