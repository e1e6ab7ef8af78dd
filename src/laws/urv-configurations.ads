--  SPDX-License-Identifier: Apache-2.0

--  The settings that the ground may change while the aircraft is switched on:
--  the control laws' table of gains, and the times of the link-loss rule
--  (EXT-2, FRM-7, D-26). The uplink carries them in place of a frame's
--  commands, as a block of its own kind:
--
--     word 1         the kind, 0400h
--     words 2 .. 5   the items, codes 0401h onward
--     words 6 .. 9   the same inverted
--     word 10        their weighted sum
--     words 11 .. 13 0
--     word 14        error/status, with the bit of another kind
--
--  No word has more than 12 bits, so that both message formats carry it.
--
--  The aircraft takes it whole or not at all. It takes it if its words agree,
--  its values are in range, the laws are on, and no law flies the aircraft. A
--  rejected configuration changes nothing.

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Frame_Times; use URV.Frame_Times;
with URV.Law_Gains;  use URV.Law_Gains;
with URV.Laws;       use URV.Laws;
with URV.Link_Loss;  use URV.Link_Loss;
with URV.Type_Codes; use URV.Type_Codes;

package URV.Configurations with Pure, SPARK_Mode is

   --  Serial distinguishes configurations. Times are in tenths of a second
   --  since the last uplink. Until Orbit_From the laws hold the flight as it
   --  was; then they orbit until End_From.
   type Setting_Item is (Serial, Gains, Orbit_From, End_From);

   subtype Field is Word range 0 .. 16#FFF#;

   type Configuration is array (Setting_Item) of Field;

   --  Permitted values

   subtype Serial_Number is Field range 1 .. Field'Last;

   subtype Orbit_Tenths is Field range 10 .. 600;
   subtype End_Tenths is Field range 20 .. 3_000;

   Last_Table : constant Field := Field (Table_Number'Last);

   function Is_In_Range (Source : Configuration) return Boolean is
     (Source (Serial) in Serial_Number
      and then Source (Gains) <= Last_Table
      and then Source (Orbit_From) in Orbit_Tenths
      and then Source (End_From) in End_Tenths
      and then Source (End_From) > Source (Orbit_From))
   with Global => null;

   function Times_Of (Source : Configuration) return Times is
     (Hold         => Hold_After,
      Orbit        => Frame_Count (Source (Orbit_From)) * Frames_Per_Tenth,
      Terminate_At => Frame_Count (Source (End_From)) * Frames_Per_Tenth)
   with
     Global => null,
     Pre    => Is_In_Range (Source);

   --  The block

   function Inverted (Value : Field) return Field is (Field'Last - Value)
   with Global => null;

   --  Each weight is odd, so a wrong bit in both forms of an item changes the
   --  sum.
   function Sum_Of (Source : Configuration) return Field is
     ((Source (Serial) + 3 * Source (Gains) + 5 * Source (Orbit_From)
       + 7 * Source (End_From)) mod 4_096)
   with Global => null;

   function Block_Of (Source : Configuration) return Uplink_Buffer is
     (Roll         => Configuration_Kind,
      Pitch        => Source (Serial),
      Yaw          => Source (Gains),
      Throttle     => Source (Orbit_From),
      Brake        => Source (End_From),
      Switch_1     => Inverted (Source (Serial)),
      Switch_2     => Inverted (Source (Gains)),
      Switch_3     => Inverted (Source (Orbit_From)),
      Switch_4     => Inverted (Source (End_From)),
      Switch_5     => Sum_Of (Source),
      Switch_6 .. Switch_8 => 0,
      Error_Status => Other_Kind)
   with Global => null;

   function Is_Twice (Value, Second : Word) return Boolean is
     (Value in Field and then Second = Inverted (Value))
   with Global => null;

   function Has_Items (Block : Uplink_Buffer) return Boolean is
     (Is_Twice (Block (Pitch), Block (Switch_1))
      and then Is_Twice (Block (Yaw), Block (Switch_2))
      and then Is_Twice (Block (Throttle), Block (Switch_3))
      and then Is_Twice (Block (Brake), Block (Switch_4)))
   with Global => null;

   function Configuration_Of (Block : Uplink_Buffer) return Configuration is
     (Serial     => Block (Pitch),
      Gains      => Block (Yaw),
      Orbit_From => Block (Throttle),
      End_From   => Block (Brake))
   with
     Global => null,
     Pre    => Has_Items (Block);

   --  All words of a block agree. The configuration may still be out of range.
   function Is_Whole (Block : Uplink_Buffer) return Boolean is
     (Is_Other_Kind (Block)
      and then Kind_Of (Block) = Configuration_Kind
      and then Has_Items (Block)
      and then Block (Switch_5) = Sum_Of (Configuration_Of (Block))
      and then Block (Switch_6) = 0
      and then Block (Switch_7) = 0
      and then Block (Switch_8) = 0)
   with Global => null;

   --  In the aircraft

   --  The configuration that was taken last, if any.
   type Setting is record
      Is_Set : Boolean := False;
      Item   : Configuration := (others => 0);
   end record
   with Predicate => (if Setting.Is_Set then Is_In_Range (Setting.Item));

   function Nothing_Set return Setting is
     (Is_Set => False, Item => (others => 0))
   with Global => null;

   --  The settings in force: the configuration if one was taken, else the
   --  node's.
   function In_Force (Set : Settings; Now : Setting) return Settings is
     (if Now.Is_Set
      then (On    => Set.On,
            By    => Times_Of (Now.Item),
            Table => Table_Number (Now.Item (Gains)))
      else Set)
   with Global => null;

   --  No law flies the aircraft: it is on the ground, or all outputs are the
   --  sticks'.
   function May_Be_Set (Flown : Laws.Memory) return Boolean is
     (not Flown.Is_Flying
      or else (Flown.Flown = All_Direct and then Is_All_Stick (Flown)))
   with Global => null;

   type Answer is
     (Taken,
      Not_Whole,      --  its words disagree
      Not_In_Range,   --  a value is not permitted
      Law_Flies,      --  a law flies the aircraft
      No_Laws);       --  the laws are off

   subtype Refused is Answer range Not_Whole .. No_Laws;

   function Answer_To
     (Block : Uplink_Buffer; Set : Settings; Flown : Laws.Memory)
      return Answer
   is
     (if not Is_Whole (Block) then Not_Whole
      elsif not Is_In_Range (Configuration_Of (Block)) then Not_In_Range
      elsif not Set.On then No_Laws
      elsif not May_Be_Set (Flown) then Law_Flies
      else Taken)
   with Global => null;

   function After
     (Now   : Setting;
      Block : Uplink_Buffer;
      Set   : Settings;
      Flown : Laws.Memory) return Setting
   is
     (if Answer_To (Block, Set, Flown) = Taken
      then (Is_Set => True, Item => Configuration_Of (Block))
      else Now)
   with Global => null;

   --  The ground's report in the row of the laws: the serial number above four
   --  bits with the table; 0 if none was taken.
   function Reported (Now : Setting) return Word is
     (if Now.Is_Set then Now.Item (Serial) * 16 + Now.Item (Gains) else 0)
   with Global => null;

end URV.Configurations;
