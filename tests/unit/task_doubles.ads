--  What a task under test is given, and a history of what it did. One test
--  at a time uses these; it begins with Clear.

with Recorded_Variables;
with URVOS;       use URVOS;
with URV.Buffers; use URV.Buffers;
with URV.Errors;  use URV.Errors;

package Task_Doubles is

   procedure Clear;

   --  The variables that tasks share.

   package Words is
     new Recorded_Variables (Channel_Words, (others => Neutral_Value));
   package Image is
     new Recorded_Variables (AD_Image, Neutral_Stick_Image);
   package Input_Up is
     new Recorded_Variables (Uplink_Buffer, Neutral_Uplink);
   package Input_Down is
     new Recorded_Variables (Downlink_Buffer, Neutral_Downlink);
   package Uplink is
     new Recorded_Variables (Uplink_Buffer, Neutral_Uplink);
   package Downlink is
     new Recorded_Variables (Downlink_Buffer, Neutral_Downlink);
   package Output_Up is
     new Recorded_Variables (Uplink_Buffer, Neutral_Uplink);
   package Output_Down is
     new Recorded_Variables (Downlink_Buffer, Neutral_Downlink);
   package Commands is
     new Recorded_Variables (Uplink_Buffer, Neutral_Uplink);

   --  The node's own bits of the error/status word; Clear clears them.
   Status : Word := 0;

   procedure Read_Status (Bits : out Word);

   --  The errors reported since Clear, and the last one's detail.
   type Error_Counts is array (Error_Kind) of Count;
   Errors      : Error_Counts := (others => 0);
   Last_Detail : Word         := 0;

   --  Expects a detail of 0 where URV.Errors says nothing of one.
   procedure Report (Error : Error_Kind; Detail : Word);

   --  Exactly these errors were reported since this was last asked, the
   --  last of them with this detail.
   type Error_List is array (Positive range <>) of Error_Kind;
   None : constant Error_List := (1 .. 0 => Error_Kind'First);

   procedure Expect_Errors
     (What     : String;
      Expected : Error_List;
      Detail   : Word := 0);

   --  Buffers to recognise: word n of a buffer with mark m is m + n, and its
   --  error/status word is 0.
   function Uplink_Of (Mark : Word) return Uplink_Buffer;
   function Downlink_Of (Mark : Word) return Downlink_Buffer;
   function Image_Of (Mark : Word; Error : Word) return AD_Image;

   procedure Expect_Buffer
     (What : String; Actual, Expected : Uplink_Buffer);
   procedure Expect_Buffer
     (What : String; Actual, Expected : Downlink_Buffer);

end Task_Doubles;
