--  SPDX-License-Identifier: Apache-2.0

with Interfaces; use Interfaces;

package body URV.Seals with SPARK_Mode is

   procedure Configure
     (This   : in out Seal;
      Format : Format_Number;
      Keys   : Key_List;
      Start  : Nonce) is
   begin
      This.Format := Format;
      This.Keys := Keys;
      This.Hellos := Hello_Keys_Of (Keys);
      This.Own := Start;
      This.Active := No_Session;
      This.Pending := None_Pending;
      This.Latest := 1;
      This.Turn := 1;
      This.In_Doubt := False;
      This.Silence := 0;
   end Configure;

   --  The result of Restarted. Without a contract the proof has the statements
   --  themselves.
   procedure Forget_Sessions (This : in out Seal);

   procedure Forget_Sessions (This : in out Seal) is
   begin
      This.Own := This.Own + 1;
      This.Active := No_Session;
      This.Pending := None_Pending;
      This.In_Doubt := False;
   end Forget_Sessions;

   procedure Restart (This : in out Seal) is
   begin
      Forget_Sessions (This);
   end Restart;

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

   procedure Grow_Older (List : in out Pending_List; Frames : Counter)
   with
     Global => null,
     Post   =>
       (for all Each in Pending_Place =>
          List (Each) = Kept (Older (List'Old (Each), Frames)));

   procedure Grow_Older (List : in out Pending_List; Frames : Counter) is
   begin
      for Each in Pending_Place loop
         Grow_Older (List (Each), Frames);

         pragma Loop_Invariant
           (for all Place in Pending_Place =>
              List (Place) =
                (if Place <= Each
                 then Kept (Older (List'Loop_Entry (Place), Frames))
                 else List'Loop_Entry (Place)));
      end loop;
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
      Grow_Older (This.Pending, Frames);
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

   --  The session that a block opens becomes the active one.
   procedure Take_New_Session (This : in out Seal; Block : Block_Data)
   with
     Global => null,
     Pre    => Opened_Place (This, Block) > 0,
     Post   =>
       This =
         With_Active
           (This'Old,
            With_Newest
              (This'Old.Pending
                 (Pending_Place (Opened_Place (This'Old, Block))),
               Block, Other (This'Old.Role)),
            None_Pending);

   procedure Take_New_Session (This : in out Seal; Block : Block_Data) is
   begin
      This.Active := This.Pending (Pending_Place (Opened_Place (This, Block)));
      Take (This.Active, Block, Other (This.Role));
      This.Pending := None_Pending;
      This.In_Doubt := False;
      This.Silence := 0;
   end Take_New_Session;

   procedure Take_Hello (This : in out Seal; Block : Block_Data)
   with
     Global => null,
     Post   => This = After_Hello (This'Old, Block);

   procedure Take_Hello (This : in out Seal; Block : Block_Data) is
   begin
      if This.Role = Aircraft then
         This.Latest := Next_Place (This.Latest);
         This.Pending (This.Latest) :=
           New_Session
             (This.Keys, Hello_Number (Block),
              Ground_Nonce   => Nonce_At (Block, Own_Place),
              Aircraft_Nonce => This.Own,
              Maker          => Aircraft);
         This.Own := This.Own + 1;
      elsif Is_Answer (This, Block) then
         This.Active :=
           New_Session
             (This.Keys, Hello_Number (Block),
              Ground_Nonce   => This.Own,
              Aircraft_Nonce => Nonce_At (Block, Own_Place),
              Maker          => Ground);
         This.Own := This.Own + 1;
         This.In_Doubt := False;
         This.Silence := 0;
      else
         This.In_Doubt := True;
      end if;
   end Take_Hello;

   procedure Give_Words
     (This   : Seal;
      Block  : Block_Data;
      Result : Outcome;
      Words  : out Block_Words)
   with
     Inline,
     Global => null,
     Post   =>
       Words =
         (if Result in Taken then Words_In (This, Block)
          else Block_Words'[others => 0]);

   procedure Give_Words
     (This   : Seal;
      Block  : Block_Data;
      Result : Outcome;
      Words  : out Block_Words) is
   begin
      if Result not in Taken then
         Words := [others => 0];
      elsif This.Format = 1 then
         Words := Decode (Block, Words_Of (Other (This.Role)));
      else
         Words := Unpacked (Block, Other (This.Role));
      end if;
   end Give_Words;

   procedure Open
     (This    : in out Seal;
      Block   : Block_Data;
      Arrived : Boolean;
      Words   : out Block_Words;
      Result  : out Outcome)
   is
      Was : constant Seal := This with Ghost;
   begin
      Result := Outcome_Of (This, Block, Arrived);
      Give_Words (This, Block, Result, Words);
      if This.Format = 2 then
         case Result is
            when Opened             =>
               Take (This.Active, Block, Other (This.Role));
               This.In_Doubt := False;
               This.Silence := 0;

            when Opened_New_Session =>
               Take_New_Session (This, Block);

            when Hello_Taken        =>
               Take_Hello (This, Block);

            when others             =>
               null;
         end case;
         pragma Assert
           (if Result = Opened_New_Session
            then This = After (Was, Block, Result));
         pragma Assert
           (if Result = Hello_Taken then This = After (Was, Block, Result));
         pragma Assert
           (if Result = Opened then This = After (Was, Block, Result));
      end if;
   end Open;

   procedure Close
     (This : in out Seal; Data : Block_Words; Block : out Block_Data) is
   begin
      if This.Active.Is_Present and then This.Active.Age = Last_Age then
         Forget_Sessions (This);
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
