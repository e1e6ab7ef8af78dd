--  SPDX-License-Identifier: Apache-2.0

--  A lost link returns if, and only if, enough frames are fresh, and it does
--  not flap (EXT-5, D-35). It is back within any n frames if at most (n - 50)
--  / 3 are silent. This holds for the aircraft's rule over any history of
--  frames, up to a million, before termination. After termination only the
--  ground's order counts; its theorem is the last one here.

with URV.Law_Gains; use URV.Law_Gains;
with URV.Link_Loss; use URV.Link_Loss;

package Theorems.Lost_Links with SPARK_Mode, Ghost is

   --  The content of a frame: no fresh uplink, or one with the switch off or
   --  on.
   type Heard is (Nothing, Switch_Off, Switch_On);

   subtype Frame_Total is Natural range 0 .. Longest;
   subtype Frame_Number is Frame_Total range 1 .. Longest;
   type History is array (Frame_Number range <>) of Heard;

   --  The number of silent frames of a history up to each frame.
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

   --  After any frames with at most (n - 50) / 3 silent ones, in any order,
   --  the link has been back, unless it was terminated. Back is the number of
   --  frames until its return.
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

   --  The link needs that many fresh frames. Since some frame at least 50
   --  before its return it has carried 50 fresh frames, and 2 more for each
   --  silent one. At most (n - 50) / 3 of n frames were silent, less than a
   --  third.
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

   --  A returned link is lost only after By.Hold silent frames in a row. From
   --  a loss its return takes at least 50 frames, so two losses are at least
   --  50 + By.Hold frames apart.
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

   --  The order that ends a termination contains at least 50 fresh frames with
   --  the switch on, plus 2 for each silent one among them, and between them
   --  no fresh frame with the switch off.
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
