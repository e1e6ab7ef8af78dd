--  SPDX-License-Identifier: Apache-2.0

--  The flight recorder's ring and its way to the ground (FTI-9, FTI-10).

with URVOS;               use URVOS;
with URV.Recorder_Blocks; use URV.Recorder_Blocks;
with URV.Recorder_Rings;  use URV.Recorder_Rings;
with URV.Recorder_Rows;   use URV.Recorder_Rows;
with URV.Recorder_Steps;  use URV.Recorder_Steps;
with URV.Buffers;         use URV.Buffers;

package Theorems.Recorder with SPARK_Mode, Ghost is

   --  Any two held rows have different places, which are in use. A row comes
   --  back from the place where it was written.
   procedure Rows_Have_Their_Own_Places
     (Kept : Ring; One, Other : Row_Number)
   with
     Global => null,
     Pre    => Is_Held (Kept, One) and then Is_Held (Kept, Other),
     Post   =>
       Place_Of (Kept, One) <= Kept.Length
       and then
         (if One /= Other
          then Place_Of (Kept, One) /= Place_Of (Kept, Other));

   --  After one more row that one is held, at the place where it was written.
   --  Each row that is still held has the same place as before, which was not
   --  written. Only the oldest one is lost, and only from a full ring.
   procedure A_New_Row_Replaces_The_Oldest (Kept : Ring; Each : Row_Number)
   with
     Global => null,
     Pre    => not Is_Over (Kept),
     Post   =>
       Is_Held (After (Kept), Kept.Next)
       and then Place_Of (After (Kept), Kept.Next) = Kept.Place
       and then
         (if Is_Held (After (Kept), Each) and then Each /= Kept.Next
          then Is_Held (Kept, Each)
            and then Place_Of (Kept, Each) /= Kept.Place
            and then Place_Of (After (Kept), Each) = Place_Of (Kept, Each))
       and then
         (if Is_Held (Kept, Each)
            and then (Kept.Held < Kept.Length or else Each /= First (Kept))
          then Is_Held (After (Kept), Each));

   --  The ground has three words of a row from four fields, and so each word
   --  from the four blocks.

   procedure Three_Words_Arrive (One, Two, Three : Word)
   with
     Global => null,
     Post   =>
       Word_From
         (Field_Of (One, Two, Three, 0), Field_Of (One, Two, Three, 1),
          Field_Of (One, Two, Three, 2), Field_Of (One, Two, Three, 3), 0)
       = One
       and then
         Word_From
           (Field_Of (One, Two, Three, 0), Field_Of (One, Two, Three, 1),
            Field_Of (One, Two, Three, 2), Field_Of (One, Two, Three, 3), 1)
         = Two
       and then
         Word_From
           (Field_Of (One, Two, Three, 0), Field_Of (One, Two, Three, 1),
            Field_Of (One, Two, Three, 2), Field_Of (One, Two, Three, 3), 2)
         = Three;

   procedure A_Row_Arrives (Item : Row; Which : Part; Three : Group)
   with
     Global => null,
     Post   =>
       Word_From
         (Field_At (Item, Which, Three, 0), Field_At (Item, Which, Three, 1),
          Field_At (Item, Which, Three, 2), Field_At (Item, Which, Three, 3),
          0)
       = Word_At (Item, First_Word (Which, Three))
       and then
         Word_From
           (Field_At (Item, Which, Three, 0), Field_At (Item, Which, Three, 1),
            Field_At (Item, Which, Three, 2), Field_At (Item, Which, Three, 3),
            1)
         = Word_At (Item, First_Word (Which, Three) + 1)
       and then
         Word_From
           (Field_At (Item, Which, Three, 0), Field_At (Item, Which, Three, 1),
            Field_At (Item, Which, Three, 2), Field_At (Item, Which, Three, 3),
            2)
         = Word_At (Item, First_Word (Which, Three) + 2);

   --  A request is read as it was made.
   procedure A_Request_Arrives (Item : Request)
   with
     Global => null,
     Post   =>
       Is_Whole (Block_Of (Item)) and then Request_Of (Block_Of (Item)) = Item;

   --  In flight, or when that is not known, no row goes down. A request is
   --  answered by one block. Without a request nothing goes down.
   procedure Nothing_Goes_Down_In_Flight
     (Sending : Line; Kept : Ring; Item : Request; Sensors : Downlink_Buffer)
   with
     Global => null,
     Pre    => not Is_On_Ground (Sensors),
     Post   =>
       (if Sending.Now /= Report
        then not Has_Block (Sending, Kept, Is_On_Ground (Sensors)))
       and then After (Sending, Kept, Is_On_Ground (Sensors)).Now = Idle
       and then Asked (Item, Kept, Is_On_Ground (Sensors)).Now = Report;

   procedure Nothing_Goes_Down_Without_A_Request
     (Sending : Line; Kept : Ring; On_Ground : Boolean)
   with
     Global => null,
     Pre    => Sending.Now = Idle,
     Post   =>
       not Has_Block (Sending, Kept, On_Ground)
       and then After (Sending, Kept, On_Ground).Now = Idle;

   --  While rows go down, the sensors and the log have each fifth frame.
   procedure Sensors_Have_Each_Fifth_Frame
     (Sending : Line; Kept : Ring; On_Ground : Boolean)
   with
     Global => null,
     Pre    => Sending.Now = Quarter,
     Post   =>
       (if Sending.Which = Part'Last
        then After (Sending, Kept, On_Ground).Now in Idle | Sensors_Turn
        else After (Sending, Kept, On_Ground).Now = Idle
          or else
            (After (Sending, Kept, On_Ground).Now = Quarter
             and then After (Sending, Kept, On_Ground).Which
                      = Sending.Which + 1));

end Theorems.Recorder;
