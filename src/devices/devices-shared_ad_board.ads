--  SPDX-License-Identifier: Apache-2.0

--  An analog-to-digital board between the controller and its hardware
--  (report, 4.1, 4.2; AD-1, ADI-1).

with URVOS;            use URVOS;
with Devices.AD_Board; use Devices.AD_Board;

package Devices.Shared_AD_Board with SPARK_Mode is

   protected type Board is

      --  The controller's side.

      procedure Initialise;

      procedure Start (Channel : Channel_Number);

      function Data return Word;

      --  The hardware's side.

      --  Wanted tells whether a conversion was started since this was last
      --  asked, and of which channel.
      procedure Take_Start
        (Wanted  : out Boolean;
         Channel : out Channel_Number);

      --  The conversion is done; Interrupt tells whether the controller is
      --  interrupted. It is not, and the value is nobody's, when the
      --  controller has abandoned that conversion, of which the hardware may
      --  not know yet.
      procedure Finish (Value : Word; Interrupt : out Boolean);

   private
      Contents : Registers;
   end Board;

end Devices.Shared_AD_Board;
