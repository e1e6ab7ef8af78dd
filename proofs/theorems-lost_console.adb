--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Lost_Console with SPARK_Mode is

   procedure In_Flight_Nothing_Fresh_Goes_Up
     (Ground     : in out Ground_Way;
      Scans      : Scan_History;
      Item       : Watch;
      Silent     : Frame_Count;
      Downlink   : Downlink_Buffer;
      Bits       : Word;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean)
   is
      pragma Unreferenced (Item, Silent, Downlink);
   begin
      A_Repeated_Scan_Is_Marked (Ground, Scans);
      A_Marked_Image_Is_Sent_As_Old
        (Ground, Scans, Bits, Order, Is_Ordered);
   end In_Flight_Nothing_Fresh_Goes_Up;

   procedure Any_History
     (Frames : Frame_History; Upto : Frame_Number; Item : out Watch)
   is
      Silent : Frame_Count := 0;
   begin
      Item := (others => <>);
      for Now in 1 .. Upto loop
         Silent :=
           (if Frames (Now).Has_Input then 0
            elsif Silent = Frame_Count'Last then Silent
            else Silent + 1);
         Item := Next (Item, Silent, Frames (Now).Downlink);

         pragma Loop_Invariant (Silent <= Frame_Count (Now));
         pragma Loop_Invariant
           (for all Each in Frame_Number =>
              (if Each <= Now
                 and then Frame_Count (Now) - Frame_Count (Each) < Silent
               then not Frames (Each).Has_Input));
         pragma Loop_Invariant
           (if Silent < Frame_Count (Now)
            then Frames (Now - Frame_Number'Base (Silent)).Has_Input);
         pragma Loop_Invariant
           (if Is_Lost (Silent)
            then Item.Input /= Live
              and then
                (if not Is_On_Ground (Item.Checks) then Item.Input = Held)
            else Item.Input = Live);
      end loop;
      pragma Assert (Is_Lost (Silent) = Is_Lost_At (Frames, Upto));
   end Any_History;

   procedure Same_Effect_As_A_Lost_Link
     (Before       : URV.Laws.Memory;
      From_Console : Uplink_Buffer;
      From_Link    : Uplink_Buffer;
      Sensors      : Downlink_Buffer;
      By           : URV.Link_Loss.Times;
      One, Other   : URV.Laws.Memory)
   is null;

   procedure On_The_Ground_The_Safe_Words_Go_Up
     (Item     : Watch;
      Silent   : Frame_Count;
      Downlink : Downlink_Buffer)
   is
      Area : constant Uplink_Buffer :=
        To_Uplink (Stamped (Neutral_Stick_Words, Fresh => True));
      pragma Unreferenced (Item, Silent, Downlink);
   begin
      pragma Assert
        (for all Name in PWM_Item =>
           Transform (Area) (Name) = Safe_Outputs (Name));
   end On_The_Ground_The_Safe_Words_Go_Up;

   procedure It_Is_Back_With_Its_First_Input
     (Item : Watch; Downlink : Downlink_Buffer)
   is null;

end Theorems.Lost_Console;
