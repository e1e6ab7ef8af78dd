--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Laws with SPARK_Mode is

   procedure Disconnect_Is_Direct
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number) is null;

   procedure A_Change_Of_Mode_Is_Bumpless
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      After    : Memory) is null;

   procedure Authority_Is_Kept
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      After    : Memory) is null;

   procedure Damping_Is_Small
     (Stick : Demand; Extra : URV.Law_Axes.Damping) is null;

   procedure Saturated_Trims_Are_Frozen
     (Roll  : Roll_Trim;
      Pitch : Pitch_Trim;
      Power : Power_Trim;
      Error : Number;
      By    : Gain) is null;

   procedure Invalid_Sensors_Disengage
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      After    : Memory) is null;

   procedure Three_Bad_Scans_Are_Enough
     (Item : Check; One, Two, Three, Witness : Word; By : Rule) is null;

   procedure Times_Are_Exact
     (Silent : Frame_Count;
      By     : Times;
      After  : out Link_Memory)
   is
   begin
      After := Linked_Again;
      for Frame in 1 .. Silent loop
         pragma Loop_Invariant
           (After.State = State_After (Frame - 1, By)
            and then After.Silent = Frame - 1);
         After := Next (After, Is_Fresh => False, Disconnect => False,
                        By => By);
      end loop;
   end Times_Are_Exact;

   procedure Nothing_Is_Skipped
     (Item : Link_Memory; Is_Fresh, Disconnect : Boolean; By : Times)
   is null;

   procedure A_Second_Brings_It_Back
     (Item : Link_Memory; Fresh : Return_Count; After : out Link_Memory)
   is
   begin
      After := Item;
      for Frame in 1 .. Fresh loop
         pragma Loop_Invariant
           (After.State = Item.State
            and then
              Integer (After.Fresh) =
                Integer (Item.Fresh) + Integer (Frame) - 1);
         After := After_Uplink (After, Disconnect => False);
         exit when After.State = Linked;
      end loop;
   end A_Second_Brings_It_Back;

   procedure Only_The_Order_Ends_Termination
     (Item : Link_Memory; Is_Fresh, Disconnect : Boolean; By : Times)
   is null;

end Theorems.Laws;
