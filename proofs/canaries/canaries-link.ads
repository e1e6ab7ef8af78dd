--  SPDX-License-Identifier: Apache-2.0

--  Claims about the real telemetry board that exceed the truth by one step.

with Telemetry;           use Telemetry;
with Telemetry.Boards;    use Telemetry.Boards;
with Telemetry.Checksum;  use Telemetry.Checksum;
with Telemetry.Headers;   use Telemetry.Headers;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Senders;   use Telemetry.Senders;
with Telemetry.Turns;     use Telemetry.Turns;
with Theorems.Link;       use Theorems.Link;
with Theorems.Silence;    use Theorems.Silence;
with URVOS;               use URVOS;

package Canaries.Link with Pure, SPARK_Mode, Ghost is

   --  False: headers differ in four bits, and some in no more.
   procedure Headers_Are_Farther_Apart (Left, Right : Byte)
   with
     Global => null,
     Pre    =>
       Is_Valid (Left) and then Is_Valid (Right) and then Left /= Right,
     Post   => Weight (Left xor Right) >= 5;  --  VC_POSTCONDITION

   --  False: two wrong bytes can cancel each other.
   procedure Two_Steps_Distinguish (Left, Right : Byte; Data, Other : Byte)
   with
     Global => null,
     Pre    => Left /= Right and then Data /= Other,
     Post   =>
       Next (Left, Data) /= Next (Right, Other);  --  VC_POSTCONDITION

   --  False: an aircraft that has waited one character time less than its dead
   --  space still waits.
   procedure Ground_Need_Not_Wait (Item : in out Board)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Control_Of (Item).Role = Aircraft
       and then Control_Of (Item).Receiver.State /= At_End
       and then not Is_Talking (Control_Of (Item)),
     Post   =>
       Is_Sound (Item)
       and then At_Rest (Item);  --  VC_POSTCONDITION

   --  False: after a parity error a good checksum does not help.
   procedure Last_Byte_Fills_The_Buffer
     (Item         : in out Receiver;
      Pair         : in out Buffer_Pair;
      Data         : Byte;
      Parity_Error : Boolean;
      Outcome      : out Event)
   with
     Global => null,
     Pre    =>
       Fits (Item, Pair, Length => 28)
       and then Item.State = In_Data
       and then Item.Received = 28
       and then Data = Item.Sum
       and then not Item.Damaged,
     Post   => Outcome.Kind = Block_Whole;  --  VC_POSTCONDITION

   --  False: a character after the guard time is ignored.
   procedure Late_Character_Is_Bad
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item)
       and then Control_Of (Item).Receiver.State = At_End
       and then not Is_Talking (Control_Of (Item)),
     Post   => Control_Of (Item).Owed = Bad;  --  VC_POSTCONDITION

   --  False: the header comes first, and every byte of data one place later.
   procedure Every_Character_Is_Data
     (Item   : Sender;
      Data   : Block_Data;
      Output : Byte)
   with
     Global => null,
     Pre    =>
       Fits (Item, Data, Length => 28)
       and then Item.Sent <= 28
       and then Data (1) = 16#1E#
       and then Output = Next_Byte (Item, Data, Length => 28),
     Post   =>
       Output = (if Item.Sent <= 1 then 16#1E#  --  VC_POSTCONDITION
                 else Data (Byte_Index (Item.Sent + 1)));

   --  False: if both buffers are full, one of them is filled again.
   procedure A_Filled_Place_Was_Empty (Pair : Buffer_Pair)
   with
     Global => null,
     Pre    => not Pair.Slots (Pair.Newest).Busy,
     Post   => not Pair.Slots (To_Fill (Pair)).Full;  --  VC_POSTCONDITION

   --  False: of two blocks not taken, the older is overwritten.
   procedure Nothing_Is_Overwritten
     (Item         : in out Board;
      Data         : Byte;
      Parity_Error : Boolean)
   with
     Global => null,
     Pre    =>
       Is_Sound (Item) and then Receive_Pair (Item).Slots (First).Full,
     Post   =>
       Receive_Pair (Item).Slots (First).Full;  --  VC_POSTCONDITION

end Canaries.Link;
