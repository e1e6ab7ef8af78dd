--  SPDX-License-Identifier: Apache-2.0

--  Access to the registers of the watchdog, one access of the bus each (BRD-6,
--  D-92).
--
--  This is a boundary of the proof: a contract here is what the reference
--  manual says of the register, and which conditions it sets. On the Cortex-M4
--  the body writes the register. In the tests the body is a simulated chip,
--  which executes these contracts.

with STM32_Watchdog.Models; use STM32_Watchdog.Models;

package STM32_Watchdog.Registers
  with
    SPARK_Mode,
    Abstract_State => Chip,
    Initializes    => Chip
is

   pragma Unevaluated_Use_Of_Old (Allow);

   function State return Watchdog_Model
   with Ghost, Global => Chip;

   procedure Write_Key (Item : Key)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   => Follows (State, With_Key (State'Old, Item));

   --  A value that is still waiting must not be written again.

   procedure Write_Divider (Value : Clock_Divider)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    =>
       State.Is_Unlocked and then not State.Waiting.Divider_Waits,
     Post   =>
       Follows
         (State,
          (State'Old with delta
             Divider => Value,
             Waiting =>
               (State'Old.Waiting with delta Divider_Waits => True)));

   procedure Write_Reload (Value : Reload_Value)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => State.Is_Unlocked and then not State.Waiting.Reload_Waits,
     Post   =>
       Follows
         (State,
          (State'Old with delta
             Reload  => Value,
             Waiting =>
               (State'Old.Waiting with delta Reload_Waits => True)));

end STM32_Watchdog.Registers;
