--  SPDX-License-Identifier: Apache-2.0

--  False claims about the link and the path of data.

with Telemetry;
with Telemetry.Boards;
with Telemetry.Checksum;
with Telemetry.Headers;
with Telemetry.Memory;
with Telemetry.Receivers;
with Telemetry.Senders;
with Telemetry.Turns;
with Theorems.In_Step;
with Theorems.Latency;
with Theorems.Link;
with Theorems.Silence;
with URV.Buffers;
with URV.PWM_Transform;
with URV.Plain_Blocks;
with URV.Seal_Blocks;
with URV.Sessions;
with URV.Sip_Hash;
with URVOS; use URVOS;
with URVOS.Frame_Clocks;
with URVOS.Frames;

package Canaries.Link with SPARK_Mode is

   --  Claims about the real telemetry board that exceed the truth by one step.

   package Boards with Ghost is

      use Telemetry;
      use Telemetry.Boards;
      use Telemetry.Checksum;
      use Telemetry.Headers;
      use Telemetry.Memory;
      use Telemetry.Receivers;
      use Telemetry.Senders;
      use Telemetry.Turns;
      use Theorems.Link;
      use Theorems.Silence;

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

      --  False: an aircraft that has waited one character time less than its
      --  dead space still waits.
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

      --  False: the header comes first, each byte of data one place later.
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

   end Boards;

   --  Claims about the sealed link that exceed the truth by one step.

   package Seals with Ghost is

      use Telemetry;
      use URV.Plain_Blocks;
      use URV.Seal_Blocks;
      use URV.Sessions;
      use URV.Sip_Hash;

      --  False: a number as many places back as there are remainders reads as
      --  another number.
      procedure One_More_May_Be_Lost (Number, Most : Counter)
      with
        Global => null,
        Pre    =>
          Number <= Most
          and then Most <= Last_Age
          and then Most - Number <= Number_Modulus,
        Post   =>
          Last_With  --  VC_POSTCONDITION
            (Number mod Number_Modulus, Number_Modulus, Most) = Number;

      --  False for words beyond 12 bits.
      procedure All_Words_Come_Through
        (Data : Block_Words; Number, Echo : Counter)
      with
        Global => null,
        Post   =>
          Field_At  --  VC_POSTCONDITION
            (Packed (Data, Ground, Number, Echo), 3) =
          Data (3);

      --  False for the newest block itself.
      procedure The_Newest_Opens_Again (Item : Session; Block : Block_Data)
      with
        Global => null,
        Pre    =>
          Item.Is_Present
          and then Number_At (Block) = Item.Newest
          and then Has_Tag
            (Block, Aircraft,
             Tag_Of (Block, Aircraft, Item.Newest, 0, Item.Down_Key)),
        Post   =>
          Opens (Block, Aircraft, Item);  --  VC_POSTCONDITION

      --  False: by the receiver's reference a block may be Most_Age old.
      procedure Every_Block_Is_A_Frame_Younger
        (Item : Session; Number, Echo, Sealed_At : Counter)
      with
        Global => null,
        Pre    =>
          Number <= Last_Age
          and then Echo <= Item.Age
          and then Is_Timely (Item, Number, Echo)
          and then Sealed_At >= Earliest (Item, Number, Echo),
        Post   =>
          Item.Age <= Sealed_At  --  VC_POSTCONDITION
          or else Item.Age - Sealed_At <= Most_Age - 1;

      --  False: all eight bytes of the tag count.
      procedure Seven_Bytes_Are_Enough
        (Block : Block_Data; With_Key : Key)
      with
        Global => null,
        Pre    =>
          (for all Where in Byte_Index range 2 .. 8 =>
             Block (Covered (Aircraft) + Where) =
               Tag_Byte
                 (Tag_Of (Block, Aircraft, 1, 0, With_Key), Where)),
        Post   =>
          Has_Tag  --  VC_POSTCONDITION
            (Block, Aircraft, Tag_Of (Block, Aircraft, 1, 0, With_Key));

   end Seals;

   --  Claims about words on their path that are false for a few words.

   package Data_Path with Ghost is

      use URVOS.Frames;
      use URV.Buffers;
      use URV.PWM_Transform;

      use URV.Plain_Blocks;

      --  False for words beyond 12 bits.
      procedure Roll_Reaches_The_Aileron (Commands : Uplink_Buffer)
      with
        Global => null,
        Post   =>
          Transform (Commands) (Left_Aileron) =  --  VC_POSTCONDITION
            Commands (Roll);

      --  False: the low byte comes second.
      procedure Low_Byte_Comes_First (High, Low : Byte)
      with
        Global => null,
        Post   =>
          Low_Byte (To_Word (High, Low)) = High;  --  VC_POSTCONDITION

      --  False for the last tick, at which the clock stops.
      procedure Clock_Runs (Now : Clock_Tick)
      with
        Global => null,
        Post   => Advanced (Now) > Now;  --  VC_POSTCONDITION

   end Data_Path;

   --  Claims about frames in step that exceed the true bound by one.

   package In_Step with Ghost is

      use Theorems.In_Step;
      use URVOS.Frame_Clocks;
      use URVOS.Frames;

      --  False: clocks drift apart before the lock answers.
      procedure It_Is_Always_A_Tick_Before (Item : Situation)
      with
        Global => null,
        Pre    => Is_In_Step (Item),
        Post   => Item.Before >= Tick_Time;  --  VC_POSTCONDITION

      --  False: a request in the last tick of a frame still has effect.
      procedure Ten_Ticks_Are_A_Frame
        (Clock   : Frame_Clock;
         Request : Frame_Request)
      with
        Global => null,
        Pre    => Clock.Now < Last_Tick,
        Post   =>
          Ticked (Clock, Request).Now = Clock.Now + 1;  --  VC_POSTCONDITION

   end In_Step;

   --  Claims about latencies that are one microsecond too strict.

   package Latency with Ghost is

      use Theorems.In_Step;
      use Theorems.Latency;

      --  False: the bound is reached.
      procedure A_Sensor_Is_A_Microsecond_Earlier (Item : Situation)
      with
        Global => null,
        Pre    => Is_In_Step (Item),
        Post   => Sensor_To_CORE (Item, 0) <= 9_891;  --  VC_POSTCONDITION

   end Latency;

end Canaries.Link;
