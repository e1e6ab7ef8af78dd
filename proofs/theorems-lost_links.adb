--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Lost_Links with SPARK_Mode is

   --  The count of silent frames never decreases.
   procedure Prove_Growth
     (Frames : History; Silent : Silent_Counts; First, Last : Frame_Total)
   with
     Global => null,
     Pre    =>
       Are_Counted (Frames, Silent)
       and then First <= Last
       and then Last <= Frames'Last,
     Post   => Silent (First) <= Silent (Last);

   procedure Prove_Growth
     (Frames : History; Silent : Silent_Counts; First, Last : Frame_Total) is
   begin
      for Frame in First + 1 .. Last loop
         pragma Assert
           (Silent (Frame) =
              Silent (Frame - 1)
              + (if Frames (Frame) = Nothing then 1 else 0));
         pragma Loop_Invariant (Silent (First) <= Silent (Frame));
      end loop;
   end Prove_Growth;

   procedure A_Proportion_Brings_It_Back
     (Item   : Link_Memory;
      Frames : History;
      Silent : Silent_Counts;
      By     : Times;
      After  : out Link_Memory;
      Back   : out Frame_Number) is
   begin
      After := Item;
      Back := 1;
      for Frame in Frames'Range loop
         pragma Loop_Invariant (After.State in Holding | Orbiting);
         pragma Loop_Invariant
           (Integer (After.Fresh)
              >= Frame - 1 - 3 * Silent (Frame - 1));
         pragma Loop_Invariant
           (After.Silent <=
              Item.Silent + Frame_Count (Silent (Frame - 1)));
         pragma Loop_Invariant
           (Frame = 1 or else After.Fresh < Return_After);
         Prove_Growth (Frames, Silent, Frame, Frames'Last);
         After := After_Frame (After, Frames (Frame), By);
         Back := Frame;
         exit when After.State = Linked;
      end loop;
   end A_Proportion_Brings_It_Back;

   procedure A_Smaller_Proportion_Does_Not
     (Item   : Link_Memory;
      Frames : History;
      Silent : Silent_Counts;
      By     : Times;
      After  : out Link_Memory;
      From   : out Positive;
      Last   : out Natural) is
   begin
      After := Item;
      From := 1;
      Last := 0;
      for Frame in Frames'Range loop
         pragma Loop_Invariant (After.State in Holding | Orbiting);
         pragma Loop_Invariant (After.Fresh < Return_After);
         pragma Loop_Invariant (Last = Frame - 1);
         pragma Loop_Invariant (From <= Frame);
         pragma Loop_Invariant
           (Integer (After.Fresh) =
              Frame - From - 3 * (Silent (Frame - 1) - Silent (From - 1)));
         After := After_Frame (After, Frames (Frame), By);
         Last := Frame;
         if After.State = Linked then
            Prove_Growth (Frames, Silent, From - 1, Last);
         end if;
         exit when After.State not in Holding | Orbiting;
         if After.Fresh = 0 then
            From := Frame + 1;
         end if;
      end loop;
   end A_Smaller_Proportion_Does_Not;

   procedure It_Does_Not_Flap
     (Frames : History;
      By     : Times;
      After  : out Link_Memory;
      Last   : out Natural) is
   begin
      After := Linked_Again;
      Last := 0;
      for Frame in Frames'Range loop
         pragma Loop_Invariant (After.State = Linked);
         pragma Loop_Invariant (Last = Frame - 1);
         pragma Loop_Invariant (After.Silent < By.Hold);
         pragma Loop_Invariant (Natural (After.Silent) <= Last);
         pragma Loop_Invariant
           (for all Earlier in Frame - Natural (After.Silent) .. Frame - 1 =>
              Frames (Earlier) = Nothing);
         After := After_Frame (After, Frames (Frame), By);
         Last := Frame;
         exit when After.State /= Linked;
      end loop;
   end It_Does_Not_Flap;

   procedure A_Return_Takes_A_Second
     (Item   : Link_Memory;
      Frames : History;
      By     : Times;
      After  : out Link_Memory) is
   begin
      After := Item;
      for Frame in Frames'Range loop
         pragma Loop_Invariant (After.State in Holding | Orbiting);
         pragma Loop_Invariant (Natural (After.Fresh) <= Frame - 1);
         After := After_Frame (After, Frames (Frame), By);
         exit when After.State = Terminated;
      end loop;
   end A_Return_Takes_A_Second;

   procedure The_Order_Is_Held
     (Item   : Link_Memory;
      Frames : History;
      Silent : Silent_Counts;
      By     : Times;
      After  : out Link_Memory;
      From   : out Positive;
      Last   : out Natural) is
   begin
      After := Item;
      From := 1;
      Last := 0;
      for Frame in Frames'Range loop
         pragma Loop_Invariant (After.State = Terminated);
         pragma Loop_Invariant (Last = Frame - 1);
         pragma Loop_Invariant (From <= Frame);
         pragma Loop_Invariant
           (Integer (After.On) =
              Frame - From - 3 * (Silent (Frame - 1) - Silent (From - 1)));
         pragma Loop_Invariant (After.On < Return_After);
         pragma Loop_Invariant
           (for all Earlier in From .. Frame - 1 =>
              Frames (Earlier) /= Switch_Off);
         After := After_Frame (After, Frames (Frame), By);
         Last := Frame;
         exit when After.State = Linked;
         if After.On = 0 then
            From := Frame + 1;
         end if;
      end loop;
   end The_Order_Is_Held;

end Theorems.Lost_Links;
