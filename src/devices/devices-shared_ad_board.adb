--  SPDX-License-Identifier: Apache-2.0

package body Devices.Shared_AD_Board with SPARK_Mode is

   protected body Board is

      procedure Initialise is
      begin
         Contents := Initialised (Contents);
      end Initialise;

      procedure Start (Channel : Channel_Number) is
      begin
         Contents := Started (Contents, Channel);
      end Start;

      function Data return Word is (Contents.Data);

      procedure Take_Start
        (Wanted  : out Boolean;
         Channel : out Channel_Number)
      is
      begin
         Wanted := Contents.Doing = Start_Wanted;
         Channel := Contents.Channel;
         Begin_Conversion (Contents);
      end Take_Start;

      procedure Finish (Value : Word; Interrupt : out Boolean) is
      begin
         Interrupt :=
           Contents.Doing = Converting and then Contents.Interrupt_Enabled;
         Finish (Contents, Value);
      end Finish;

   end Board;

end Devices.Shared_AD_Board;
