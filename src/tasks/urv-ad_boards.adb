--  SPDX-License-Identifier: Apache-2.0

package body URV.AD_Boards with SPARK_Mode is

   --  The operations in place, for one call each or for all in one.

   procedure Begin_Scan
     (Contents : in out Registers;
      Item     : in out Scan;
      Reached  : out Channel_Count)
   with
     Inline,
     Post =>
       Reached = Item'Old.Current
       and then Item = Restarted (Item'Old)
       and then Contents = Started (Contents'Old, Channel_Number'(0));

   procedure Take_Value
     (Contents : in out Registers;
      Item     : in out Scan;
      Next     : out Next_Step)
   with
     Inline,
     Post =>
       Contents =
         (if Next = Start_Channel
          then Started (Contents'Old, Channel_Number (Item.Current))
          else Contents'Old)
       and then
         (if Is_Complete (Item'Old)
          then Next = Ignore and then Item = Item'Old
          else Item.Current = Item'Old.Current + 1
            and then Item.Words =
              (Item'Old.Words with delta
                 Channel (Item'Old.Current) => Contents'Old.Data)
            and then Next =
              (if Is_Complete (Item) then Send_Words else Start_Channel));

   procedure Take_Start
     (Contents : in out Registers;
      Wanted   : out Boolean;
      Channel  : out Channel_Number)
   with
     Inline,
     Post =>
       Wanted = (Contents'Old.Doing = Start_Wanted)
       and then Channel = Contents'Old.Channel
       and then Contents = Begun (Contents'Old);

   procedure Finish
     (Contents  : in out Registers;
      Value     : Word;
      Interrupt : out Boolean)
   with
     Inline,
     Post =>
       Interrupt =
         (Contents'Old.Doing = Converting
          and then Contents'Old.Interrupt_Enabled)
       and then Contents = Finished (Contents'Old, Value);

   --  A value for an abandoned conversion changes no scan. Otherwise it is the
   --  word of the scan's channel, and a scan that goes on has its next channel
   --  converted.
   procedure Pass_Value
     (Contents : in out Registers;
      Item     : in out Scan;
      Value    : Word;
      Next     : out Successor)
   with
     Inline,
     Post =>
       (if Contents'Old.Doing = Converting
          and then Contents'Old.Interrupt_Enabled
        then
          (if Is_Complete (Item'Old)
           then Next = Not_Expected and then Item = Item'Old
           else Item.Current = Item'Old.Current + 1
             and then Item.Words =
               (Item'Old.Words with delta
                  Buffers.Channel (Item'Old.Current) => Value)
             and then Next =
               (if Is_Complete (Item) then Scan_Complete
                else Successor (Item.Current)))
        else Item = Item'Old
          and then Next =
            (if Contents'Old.Doing = Start_Wanted
             then Successor (Contents'Old.Channel)
             else Nothing_Wanted))
       and then Contents.Doing /= Start_Wanted;

   procedure Begin_Scan
     (Contents : in out Registers;
      Item     : in out Scan;
      Reached  : out Channel_Count) is
   begin
      Reached := Item.Current;
      Begin_Again (Item);
      Devices.AD_Board.Start (Contents, 0);
   end Begin_Scan;

   procedure Take_Value
     (Contents : in out Registers;
      Item     : in out Scan;
      Next     : out Next_Step) is
   begin
      Store (Item, Contents.Data, Next);
      if Next = Start_Channel then
         Start (Contents, Channel_Number (Item.Current));
      end if;
   end Take_Value;

   procedure Take_Start
     (Contents : in out Registers;
      Wanted   : out Boolean;
      Channel  : out Channel_Number) is
   begin
      Wanted := Contents.Doing = Start_Wanted;
      Channel := Contents.Channel;
      Begin_Conversion (Contents);
   end Take_Start;

   procedure Finish
     (Contents  : in out Registers;
      Value     : Word;
      Interrupt : out Boolean) is
   begin
      Interrupt :=
        Contents.Doing = Converting and then Contents.Interrupt_Enabled;
      Finish (Contents, Value);
   end Finish;

   procedure Pass_Value
     (Contents : in out Registers;
      Item     : in out Scan;
      Value    : Word;
      Next     : out Successor)
   is
      Interrupt : Boolean;
      Wanted    : Boolean;
      Step      : Next_Step;
      Number    : Channel_Number;
   begin
      Finish (Contents, Value, Interrupt);
      if Interrupt then
         Take_Value (Contents, Item, Step);
      else
         Step := Discard;
      end if;
      Take_Start (Contents, Wanted, Number);
      Next :=
        (case Step is
            when Send_Words              => Scan_Complete,
            when Ignore                  => Not_Expected,
            when Start_Channel | Discard =>
              (if Wanted then Successor (Number) else Nothing_Wanted));
   end Pass_Value;

   protected body Board is

      procedure Initialise is
      begin
         Contents := Initialised (Contents);
      end Initialise;

      procedure Begin_Scan (Reached : out Channel_Count) is
      begin
         Begin_Scan (Contents, Item, Reached);
      end Begin_Scan;

      procedure Take_Value (Value : out Word; Next : out Next_Step) is
      begin
         Value := Contents.Data;
         Take_Value (Contents, Item, Next);
      end Take_Value;

      function Words return Channel_Words is (Item.Words);

      procedure Take_Start
        (Wanted  : out Boolean;
         Channel : out Channel_Number) is
      begin
         Take_Start (Contents, Wanted, Channel);
      end Take_Start;

      procedure Finish (Value : Word; Interrupt : out Boolean) is
      begin
         Finish (Contents, Value, Interrupt);
      end Finish;

      procedure Pass_Value (Value : Word; Next : out Successor) is
      begin
         Pass_Value (Contents, Item, Value, Next);
      end Pass_Value;

   end Board;

end URV.AD_Boards;
