--  SPDX-License-Identifier: Apache-2.0

--  How a lost link returns, over any history of frames (EXT-5, D-35): on a
--  proportion of fresh frames, on no smaller one, and without flapping.

with URV.Law_Gains; use URV.Law_Gains;
with URV.Link_Loss; use URV.Link_Loss;

package Theorems.Lost_Links with SPARK_Mode, Ghost is

   --  What a frame has brought: no fresh uplink, or one with its disconnect
   --  switch.
   type Heard is (Nothing, Switch_Off, Switch_On);

   subtype Frame_Total is Natural range 0 .. Longest;
   subtype Frame_Number is Frame_Total range 1 .. Longest;
   type History is array (Frame_Number range <>) of Heard;

   --  How many of a history's frames were silent, up to each.
   type Silent_Counts is array (Frame_Total range <>) of Frame_Total;

   function Are_Counted
     (Frames : History; Silent : Silent_Counts) return Boolean
   is
     (Frames'First = 1
      and then Frames'Last >= 0
      and then Silent'First = 0
      and then Silent'Last = Frames'Last
      and then Silent (0) = 0
      and then
        (for all Frame in Frames'Range =>
           Silent (Frame) =
             Silent (Frame - 1)
             + (if Frames (Frame) = Nothing then 1 else 0)))
   with Global => null;

   function After_Frame
     (Item : Link_Memory; Frame : Heard; By : Times) return Link_Memory
   is
     (Next
        (Item,
         Is_Fresh   => Frame /= Nothing,
         Disconnect => Frame = Switch_On,
         By         => By))
   with Global => null;

   --  After any frames of which at most (n - 50) / 3 are silent, in any
   --  order, the link has been back, if it was not terminated before. Back is
   --  the number of frames that it took.
   procedure A_Proportion_Brings_It_Back
     (Item   : Link_Memory;
      Frames : History;
      Silent : Silent_Counts;
      By     : Times;
      After  : out Link_Memory;
      Back   : out Frame_Number)
   with
     Global => null,
     Pre    =>
       Item.State in Holding | Orbiting
       and then Are_Counted (Frames, Silent)
       and then Frames'Last - 3 * Silent (Frames'Last) >= Return_After
       and then Natural (Item.Silent) + Silent (Frames'Last)
                  < Natural (By.Terminate_At),
     Post   =>
       Back <= Frames'Last
       and then After = Linked_Again;

   --  The link returns after no fewer fresh frames: since a frame not later
   --  than 50 before its return it has carried 50 fresh frames, and 2 more
   --  for each silent one. Of n frames no more than (n - 50) / 3 were silent,
   --  less than a third.
   procedure A_Smaller_Proportion_Does_Not
     (Item   : Link_Memory;
      Frames : History;
      Silent : Silent_Counts;
      By     : Times;
      After  : out Link_Memory;
      From   : out Positive;
      Last   : out Natural)
   with
     Global => null,
     Pre    =>
       Item.State in Holding | Orbiting
       and then Item.Fresh = 0
       and then Are_Counted (Frames, Silent),
     Post   =>
       Last <= Frames'Last
       and then
         (if After.State = Linked
          then From <= Last
            and then Last - From + 1 >= Return_After
            and then
              Last - From + 1 - 3 * (Silent (Last) - Silent (From - 1)) =
                Return_After
          else Last = Frames'Last
               or else After.State = Terminated);

   --  A link that has returned is lost after By.Hold silent frames one after
   --  the other, as ever, and by nothing else. From a loss its return takes
   --  50 frames at least, so two losses are 50 + By.Hold frames apart.
   procedure It_Does_Not_Flap
     (Frames : History;
      By     : Times;
      After  : out Link_Memory;
      Last   : out Natural)
   with
     Global => null,
     Pre    => Frames'First = 1 and then Frames'Last >= 0,
     Post   =>
       Last <= Frames'Last
       and then
         (if After.State = Linked
          then Last = Frames'Last
          else After.State = Holding
            and then After.Fresh = 0
            and then Last >= Positive (By.Hold)
            and then
              (for all Frame in Last - Positive (By.Hold) + 1 .. Last =>
                 Frames (Frame) = Nothing));

   procedure A_Return_Takes_A_Second
     (Item   : Link_Memory;
      Frames : History;
      By     : Times;
      After  : out Link_Memory)
   with
     Global => null,
     Pre    =>
       Item.State in Holding | Orbiting
       and then Item.Fresh = 0
       and then Frames'First = 1
       and then Frames'Last < Return_After,
     Post   => After.State in Holding .. Terminated;

   --  The order that ends a termination has carried, without a frame of the
   --  other kind between them, 50 fresh frames with the switch on at least,
   --  and 2 more for each silent one among them.
   procedure The_Order_Is_Held
     (Item   : Link_Memory;
      Frames : History;
      Silent : Silent_Counts;
      By     : Times;
      After  : out Link_Memory;
      From   : out Positive;
      Last   : out Natural)
   with
     Global => null,
     Pre    =>
       Item.State = Terminated
       and then Item.On = 0
       and then Are_Counted (Frames, Silent),
     Post   =>
       Last <= Frames'Last
       and then
         (if After.State = Linked
          then From <= Last
            and then
              Last - From + 1 - 3 * (Silent (Last) - Silent (From - 1)) =
                Return_After
            and then (for all Frame in From .. Last =>
                        Frames (Frame) /= Switch_Off)
          else After.State = Terminated and then Last = Frames'Last);

end Theorems.Lost_Links;
