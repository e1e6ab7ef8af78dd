--  SPDX-License-Identifier: Apache-2.0

--  The form of each kind of fault in a script.

private package Sim.Faults.Grammar is

   --  Before the name of a servo.
   Servo_Word : constant String := "surface";

   --  The word between the time and the kind.
   type Subject is (Nothing, A_Path, A_Node, The_Ground, A_Servo);

   --  A parameter that may follow the kind.
   type Parameter is
     (None, A_Duration, A_Probability, An_Ordinal, A_Mask, A_Byte,
      A_Board, A_Restart, A_ROM_Address, A_ROM_Mask, A_RAM_Address,
      A_RAM_Mask, A_Place, A_Speed);
   type Parameter_List is array (1 .. 2) of Parameter;

   type Form is record
      Before : Subject;
      After  : Parameter_List;
   end record;

   --  The form of each kind.
   Forms : constant array (Fault_Kind) of Form :=
     (Cut        => (Nothing, (A_Duration, None)),
      Bit_Errors => (A_Path, (A_Probability, A_Duration)),
      Replay     => (A_Path, (An_Ordinal, A_Duration)),
      Flip       => (A_Path, (An_Ordinal, A_Mask)),
      Drop       => (A_Path, (An_Ordinal, None)),
      Duplicate  => (A_Path, (An_Ordinal, None)),
      Insert     => (A_Path, (An_Ordinal, A_Byte)),
      Stall      => (A_Node, (A_Board, A_Duration)),
      Reset      => (A_Node, (A_Restart, None)),
      ROM_Harm   => (A_Node, (A_ROM_Address, A_ROM_Mask)),
      RAM_Harm   => (A_Node, (A_RAM_Address, A_RAM_Mask)),
      Halt       => (A_Node, (None, None)),
      Bus_Error  => (A_Node, (None, None)),
      Lost_Console => (The_Ground, (A_Duration, None)),
      Stuck      => (A_Servo, (A_Place, None)),
      Float      => (A_Servo, (None, None)),
      Slow       => (A_Servo, (A_Speed, None)));

   --  A parameter that may be left out.
   function Is_Optional (Item : Parameter) return Boolean is
     (Item = A_Place);

   function Name (Kind : Fault_Kind) return String is
     (case Kind is
         when Cut        => "cut",
         when Bit_Errors => "ber",
         when Replay     => "replay",
         when Flip       => "flip",
         when Drop       => "drop",
         when Duplicate  => "dup",
         when Insert     => "insert",
         when Stall      => "stall",
         when Reset      => "reset",
         when ROM_Harm   => "rom",
         when RAM_Harm   => "ram",
         when Halt       => "halt",
         when Bus_Error  => "bus_error",
         when Lost_Console => "console",
         when Stuck      => "stuck",
         when Float      => "float",
         when Slow       => "slow");

   function Name (Item : Subject) return String is
     (case Item is
         when Nothing => "",
         when A_Path  => "up|down ",
         when A_Node  => "mcs|gsc ",
         when The_Ground => "gsc ",
         when A_Servo => Servo_Word & " NAME ");

   --  The parameter's name in a description of the form.
   function Name (Item : Parameter) return String is
     (case Item is
         when None          => "",
         when A_Duration    => " DURATION_MS",
         when A_Probability => " P",
         when An_Ordinal    => " N",
         when A_Mask        => " MASK",
         when A_Byte        => " BYTE",
         when A_Board       => " adc|telemetry",
         when A_Restart     => " cold|warm|processor|telemetry",
         when A_ROM_Address => " ADDRESS",
         when A_ROM_Mask    => " MASK",
         when A_RAM_Address => " ADDRESS",
         when A_RAM_Mask    => " MASK",
         when A_Place       => " [WORD]",
         when A_Speed       => " PERCENT");

   --  The whole line of such a fault.
   function Image (Kind : Fault_Kind) return String is
     ("TIME_MS "
      & Name (Forms (Kind).Before) & Name (Kind)
      & Name (Forms (Kind).After (1))
      & Name (Forms (Kind).After (2)));

end Sim.Faults.Grammar;
