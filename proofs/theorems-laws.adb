--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Laws with SPARK_Mode is

   procedure Disconnect_Is_Direct
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs) is null;

   procedure A_Change_Of_Mode_Is_Bumpless
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs;
      After    : Memory) is null;

   procedure Authority_Is_Kept
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs;
      After    : Memory) is null;

   procedure Damping_Is_Small
     (Stick : Demand; Extra : URV.Law_Axes.Damping) is null;

   procedure Saturated_Trims_Never_Wind_Up
     (Roll   : Roll_Trim;
      Pitch  : Pitch_Trim;
      Height : Height_Trim;
      Power  : Power_Trim;
      Error  : Number;
      Output : Saturation;
      By     : Gain) is null;

   procedure Roll_Trim_Recovers
     (Start  : Roll_Trim;
      Errors : Error_History;
      Output : Saturation;
      Table  : Table_Number;
      After  : out Roll_Trim)
   is
      Step    : constant Positive :=
        Roll_Integrated * Gains_Of (Table).Bank_Integral_Gain / Per_Angle;
      Falling : constant Boolean :=
        (for all Error of Errors => Error <= -Roll_Integrated)
        and then not Output.Is_Low;
      Rising  : constant Boolean :=
        (for all Error of Errors => Error >= Roll_Integrated)
        and then not Output.Is_High;
   begin
      After := Start;
      for Frame in Errors'Range loop
         pragma Loop_Invariant
           (if Falling
            then After <= Integer'Max (0, Start - (Frame - 1) * Step));
         pragma Loop_Invariant
           (if Rising
            then After >= Integer'Min
              (0, Start + (Frame - 1) * Step));
         After := Next_Roll_Trim
           (After, Errors (Frame), Output,
            Gains_Of (Table).Bank_Integral_Gain);
      end loop;
   end Roll_Trim_Recovers;

   procedure Pitch_Trim_Recovers
     (Start  : Pitch_Trim;
      Errors : Error_History;
      Output : Saturation;
      Table  : Table_Number;
      After  : out Pitch_Trim)
   is
      Step    : constant Positive :=
        Pitch_Integrated * Gains_Of (Table).Pitch_Integral_Gain / Per_Angle;
      Falling : constant Boolean :=
        (for all Error of Errors => Error <= -Pitch_Integrated)
        and then not Output.Is_Low;
      Rising  : constant Boolean :=
        (for all Error of Errors => Error >= Pitch_Integrated)
        and then not Output.Is_High;
   begin
      After := Start;
      for Frame in Errors'Range loop
         pragma Loop_Invariant
           (if Falling
            then After <= Integer'Max (0, Start - (Frame - 1) * Step));
         pragma Loop_Invariant
           (if Rising
            then After >= Integer'Min
              (0, Start + (Frame - 1) * Step));
         After := Next_Pitch_Trim
           (After, Errors (Frame), Output,
            Gains_Of (Table).Pitch_Integral_Gain);
      end loop;
   end Pitch_Trim_Recovers;

   procedure Height_Trim_Recovers
     (Start  : Height_Trim;
      Errors : Error_History;
      Output : Saturation;
      After  : out Height_Trim)
   is
      Step    : constant Positive :=
        Height_Integrated * Height_Integral_Gain / Per_Climb;
      Falling : constant Boolean :=
        (for all Error of Errors => Error <= -Height_Integrated)
        and then not Output.Is_Low;
      Rising  : constant Boolean :=
        (for all Error of Errors => Error >= Height_Integrated)
        and then not Output.Is_High;
   begin
      After := Start;
      for Frame in Errors'Range loop
         pragma Loop_Invariant
           (if Falling
            then After <= Integer'Max (0, Start - (Frame - 1) * Step));
         pragma Loop_Invariant
           (if Rising
            then After >= Integer'Min
              (0, Start + (Frame - 1) * Step));
         After := Next_Height_Trim (After, Errors (Frame), Output);
      end loop;
   end Height_Trim_Recovers;

   procedure Power_Trim_Recovers
     (Start  : Power_Trim;
      Errors : Error_History;
      Output : Saturation;
      After  : out Power_Trim)
   is
      Step    : constant Positive :=
        Large_Speed_Error * Speed_Integral_Gain / Per_Speed;
      Falling : constant Boolean :=
        (for all Error of Errors => Error <= -Large_Speed_Error)
        and then not Output.Is_Low;
      Rising  : constant Boolean :=
        (for all Error of Errors => Error >= Large_Speed_Error)
        and then not Output.Is_High;
   begin
      After := Start;
      for Frame in Errors'Range loop
         pragma Loop_Invariant
           (if Falling
            then After <= Integer'Max (0, Start - (Frame - 1) * Step));
         pragma Loop_Invariant
           (if Rising
            then After >= Integer'Min
              (Power_Trim'Last, Start + (Frame - 1) * Step));
         After := Next_Power_Trim (After, Errors (Frame), Output);
      end loop;
   end Power_Trim_Recovers;

   procedure References_Arrive
     (Bank, Bank_Target   : Bank_Command;
      Pitch, Pitch_Target : Pitch_Command;
      Bank_After          : out Number;
      Pitch_After         : out Number)
   is
   begin
      Bank_After := Bank;
      for Frame in 1 .. Bank_Frames loop
         pragma Loop_Invariant (Bank_After in Bank_Command);
         pragma Loop_Invariant
           (abs (Bank_Target - Bank_After) <=
              Integer'Max
                (0, abs (Bank_Target - Bank) - (Frame - 1) * Bank_Slew));
         Bank_After := Stepped (Bank_After, Bank_Target, Bank_Slew);
      end loop;
      Pitch_After := Pitch;
      for Frame in 1 .. Pitch_Command_Frames loop
         pragma Loop_Invariant (Pitch_After in Pitch_Command);
         pragma Loop_Invariant
           (abs (Pitch_Target - Pitch_After) <=
              Integer'Max
                (0, abs (Pitch_Target - Pitch) - (Frame - 1) * Pitch_Slew));
         Pitch_After := Stepped (Pitch_After, Pitch_Target, Pitch_Slew);
      end loop;
   end References_Arrive;

   procedure Invalid_Sensors_Disengage
     (Item     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs;
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
