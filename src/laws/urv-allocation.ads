--  SPDX-License-Identifier: Apache-2.0

--  The servo words for the commands, also with failed surfaces (EXT-6).
--
--  Without failures they are those of figure 13. A failed surface rests at its
--  measured position, not at that of figure 13. The other surfaces supply the
--  moments that it lacks, by a weighted pseudo-inverse for each failure,
--  computed off line (URV.Allocation_Table). If an aileron would have to move
--  beyond half its travel, the flaps of one side slowly supply the rest.

with URVOS;                use URVOS;
with URV.Allocation_Table; use URV.Allocation_Table;
with URV.Buffers;          use URV.Buffers;
with URV.Law_Units;        use URV.Law_Units;
with URV.PWM_Transform;    use URV.PWM_Transform;
with URV.Surfaces;         use URV.Surfaces;

package URV.Allocation with Pure, SPARK_Mode is

   --  The failed surfaces, and the measured position of each surface.
   type Health is record
      Failed : Surface_Flags   := None;
      Places : Surface_Demands := (others => 0);
   end record;

   All_Well : constant Health :=
     (Failed => (others => False), Places => (others => 0));

   --  The failures that the PWM task makes up for: none unless a law flies.
   function Reported_Health (Now : Health; By_Law : Boolean) return Health is
     (if By_Law then Now else All_Well)
   with Global => null;

   --  The part of a failed surface's demand that is missing.
   subtype Deficit is Number range -4_095 .. 4_095;

   type Deficits is array (Surface) of Deficit;

   function Missing_Of
     (Wanted : Surface_Demands; Now : Health) return Deficits
   is
     (for Item in Surface =>
        (if Now.Failed (Item) then Wanted (Item) - Now.Places (Item)
         else 0))
   with Global => null;

   --  A surface's share of the missing part. The sum of all ten is within
   --  Number.
   subtype Part is Number range -20_000 .. 20_000;

   function Part_For
     (Failed, Helper : Surface; Missing : Deficit) return Part
   is
     (Gains (Failed) (Helper) * Missing / Unit)
   with Global => null;

   --  A surface's contribution for all failed surfaces.
   subtype Help is Number range -200_000 .. 200_000;

   function Help_Of (Helper : Surface; Missing : Deficits) return Help
   with Global => null;

   --  The largest demand on an aileron. For the excess the flaps move: left
   --  ones down, right ones up.
   Aileron_Share : constant := 1_000;

   function Beyond_Share (Wanted : Number) return Number is
     (Wanted - Within (Wanted, -Aileron_Share, Aileron_Share))
   with
     Global => null,
     Pre    => Wanted in -210_000 .. 210_000,
     Post   => Beyond_Share'Result in -210_000 .. 210_000;

   --  A flap below its demand rolls the aircraft away from the flap's side.
   --  A word above an aileron's neutral word rolls to the right.

   function Is_Left (Item : Flap) return Boolean is
     (Item in Left_Flap_1 | Left_Flap_2)
   with Global => null;

   --  The roll of a flap, in words of an aileron.
   function Roll_By (Item : Flap; Down : Deficit) return Number is
     (Down * Roll_Of_Flap (Item) / Unit)
   with
     Global => null,
     Post   =>
       Roll_By'Result in -2_500 .. 2_500
       and then
         (if Down = 0 or else Is_Left (Item) = (Down > 0)
          then Roll_By'Result >= 0)
       and then
         (if Down = 0 or else Is_Left (Item) = (Down < 0)
          then Roll_By'Result <= 0);

   --  A flap's part of an aileron's demand beyond the aileron's own share.
   function Flap_Part (Item : Flap; Beyond : Number) return Number is
     (Beyond * Flap_For_Roll / Unit * (if Is_Left (Item) then 1 else -1))
   with
     Global => null,
     Pre    => Beyond in -210_000 .. 210_000,
     Post   =>
       Flap_Part'Result in -400_000 .. 400_000
       and then
         (if Beyond = 0 or else Is_Left (Item) = (Beyond > 0)
          then Flap_Part'Result >= 0)
       and then
         (if Beyond = 0 or else Is_Left (Item) = (Beyond < 0)
          then Flap_Part'Result <= 0);

   function Rolls_Right
     (Item : Flap; Wanted : Surface_Demands; Now : Health) return Boolean
   is
     (Now.Failed (Item)
      or else Now.Places (Item) = Wanted (Item)
      or else Is_Left (Item) = (Now.Places (Item) > Wanted (Item)))
   with Global => null, Ghost;

   function Rolls_Left
     (Item : Flap; Wanted : Surface_Demands; Now : Health) return Boolean
   is
     (Now.Failed (Item)
      or else Now.Places (Item) = Wanted (Item)
      or else Is_Left (Item) = (Now.Places (Item) < Wanted (Item)))
   with Global => null, Ghost;

   --  The effect of the sound flaps as ailerons, in words of an aileron,
   --  from their measured positions. Flaps that agree roll to their side.
   subtype Flap_Roll is Number range -10_000 .. 10_000;

   function Rolled_By_Flaps
     (Wanted : Surface_Demands; Now : Health) return Flap_Roll
   with
     Global => null,
     Post   =>
       (if (for all Item in Flap => Rolls_Right (Item, Wanted, Now))
        then Rolled_By_Flaps'Result >= 0)
       and then
         (if (for all Item in Flap => Rolls_Left (Item, Wanted, Now))
          then Rolled_By_Flaps'Result <= 0);

   --  The positions that the surfaces shall take.
   function Demands
     (Wanted : Surface_Demands; Now : Health) return Surface_Demands
   with
     Global => null,
     Post   =>
       (if Now.Failed = None then Demands'Result = Wanted
        else
          (for all Item in Surface =>
             (if Now.Failed (Item)
              then Demands'Result (Item) = Wanted (Item)
              else Demands'Result (Item) in
                     Lowest (Item) .. Highest (Item))));

   --  The words of all 14 outputs.
   function Servos (Commands : Uplink_Buffer; Now : Health) return PWM_Buffer
   with
     Global => null,
     Post   =>
       --  Without failures it is figure 13, bit for bit.
       (if Now.Failed = None then Servos'Result = Transform (Commands))

       --  All servo words are within the converter's range.
       and then
         (for all Item in Servo_Item =>
            Servos'Result (Item) in Converter_Value)

       --  The other outputs are always figure 13's.
       and then Servos'Result (Steering) = Transform (Commands) (Steering)
       and then Servos'Result (Throttle) = Transform (Commands) (Throttle)
       and then Servos'Result (Brake) = Transform (Commands) (Brake)
       and then Servos'Result (Discretes) = Transform (Commands) (Discretes)

       and then
         (if Now.Failed /= None
          then
            (for all Item in Surface =>
               Demand_Of (Servos'Result (Servo_Of (Item))) =
                 Demands (Demands_Of (Transform (Commands)), Now) (Item)));

end URV.Allocation;
