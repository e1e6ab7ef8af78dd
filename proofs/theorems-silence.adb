--  SPDX-License-Identifier: Apache-2.0

with URVOS; use URVOS;

package body Theorems.Silence with SPARK_Mode is

   procedure No_State_Is_Far (Item : Board) is null;

   --  A board that is not at rest comes closer to rest with each character, or
   --  waits.
   procedure Speaks_Or_Waits
     (Item             : Control;
      Waiting, On_Line : Buffer_Pair;
      After            : Control)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then not Is_At_Rest (Item)
       and then Fits (Prepared (Item, Waiting), On_Line)
       and then Fits (After, On_Line)
       and then After = Spoken (Prepared (Item, Waiting), On_Line),
     Post   =>
       Fits (Item, On_Line)
       and then
         (if After.Line_Taken
          then Distance (After) < Distance (Item)
          else Is_Waiting (After)
            and then Distance (After) = Distance (Item));

   --  A waiting board comes closer to rest with time. After is its control
   --  then, and Pair the receive pair.
   procedure Waits_Not_For_Ever
     (Item         : Control;
      Pair, Blocks : Buffer_Pair;
      After        : Control)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Is_Waiting (Item)
       and then After =
         (if Is_Judged_After (Item, 1) then Judged (Item, Pair)
          else Elapsed (Item, 1, Blocks)),
     Post   => Distance (After) < Distance (Item);

   procedure Speaks_Or_Waits
     (Item             : Control;
      Waiting, On_Line : Buffer_Pair;
      After            : Control)
   is
   begin
      pragma Assert (Prepared (Item, Waiting) = Item);
      pragma Assert (After = Spoken (Item, On_Line));
      pragma Assert (After.Receiver = Item.Receiver);
      pragma Assert (if After.Line_Taken then not Has_Message (Item.Receiver));
   end Speaks_Or_Waits;

   procedure Waits_Not_For_Ever
     (Item         : Control;
      Pair, Blocks : Buffer_Pair;
      After        : Control)
   is null;

   procedure Live_On (Item : in out Board) is
      Before  : constant Turns.Control := Control_Of (Item);
      Waiting : constant Buffer_Pair   := Transmit_Pair (Item);
      Send    : Boolean;
      Data    : Byte;
   begin
      Next_Character (Item, Send, Data);
      Speaks_Or_Waits
        (Before, Waiting, Transmit_Pair (Item), Control_Of (Item));
      if not Send then
         declare
            Spoken  : constant Turns.Control := Control_Of (Item);
            On_Line : constant Buffer_Pair   := Transmit_Pair (Item);
         begin
            Elapse (Item, 1);
            Waits_Not_For_Ever
              (Spoken, Receive_Pair (Item), On_Line, Control_Of (Item));
         end;
      end if;
      pragma Unreferenced (Data);
   end Live_On;

   procedure Comes_To_Rest (Item : in out Board; Times : out Natural) is
   begin
      if At_Rest (Item) then
         Times := 0;
      else
         Live_On (Item);
         Comes_To_Rest (Item, Times);
         Times := Times + 1;
      end if;
   end Comes_To_Rest;

   procedure Ground_Waits_Longer_Than_Aircraft
     (Item : in out Board; Times : out Natural)
   is
   begin
      Comes_To_Rest (Item, Times);
   end Ground_Waits_Longer_Than_Aircraft;

   procedure No_Third_In_A_Row (Item : Control; Blocks : Buffer_Pair) is null;

   procedure A_Reset_Starts_A_Row (Item : Control; Blocks : Buffer_Pair)
   is null;

   procedure Free_After_Idle_Time
     (Item : Control; Time : Character_Times; Blocks : Buffer_Pair) is null;

   procedure An_Answer_Is_Waited_For
     (Item   : Control;
      Line   : Line_Delay;
      Time   : Character_Times;
      Blocks : Buffer_Pair) is null;

   procedure An_Exchange_Fits_Into_A_Frame (Round_Trip : Round_Trip_Time)
   is null;

end Theorems.Silence;
