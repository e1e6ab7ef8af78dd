--  SPDX-License-Identifier: Apache-2.0

--  The decision of the PWM task (D-70): when it writes to the servos, and
--  which words (report, 4.8; PWM-1, SAF-2, SAF-3, D-14, EXT-6, FTI-3, D-85).
--  The task receives, calls these functions, writes and reports;
--  Theorems.Safety calls the same functions. Each is an expression function:
--  its text is its contract.

with Devices.PWM_Board; use Devices.PWM_Board;
with URV.Allocation;    use URV.Allocation;
with URV.Buffers;       use URV.Buffers;
with URV.PWM_Layout;
with URV.Test_Inputs;   use URV.Test_Inputs;

package URV.PWM_Steps with Pure, SPARK_Mode is

   --  Commands that are marked as old move nothing.
   function Is_Written (Item : Uplink_Buffer; Fresh : Boolean) return Boolean
   is
     (Fresh and then not Buffers.Is_Old (Item))
   with Global => null;

   --  The board's words for the commands, with the test inputs.
   function Area_Of
     (Item : Uplink_Buffer; Reported : Health; Added : Increments)
      return Data_Area
   is
     (PWM_Layout.To_Data_Area (With_Inputs (Servos (Item, Reported), Added)))
   with Global => null;

end URV.PWM_Steps;
