--  SPDX-License-Identifier: Apache-2.0

--  An analog-to-digital board, shared by the controller and the board's
--  hardware (report, 4.1, 4.2; AD-1, ADI-1).

with URVOS;            use URVOS;
with Devices.AD_Board; use Devices.AD_Board;

package Devices.Shared_AD_Board with SPARK_Mode is

   protected type Board is

      --  The controller's side

      procedure Initialise;

      procedure Start (Channel : Channel_Number);

      function Data return Word;

      --  The hardware's side

      --  Wanted is True if a conversion of Channel was started since the last
      --  call.
      procedure Take_Start
        (Wanted  : out Boolean;
         Channel : out Channel_Number);

      --  The conversion is done; Interrupt says whether to interrupt the
      --  controller. If the controller has abandoned this conversion, which
      --  the hardware may not know yet, it is not interrupted and the value is
      --  discarded.
      procedure Finish (Value : Word; Interrupt : out Boolean);

   private
      Contents : Registers;
   end Board;

end Devices.Shared_AD_Board;
