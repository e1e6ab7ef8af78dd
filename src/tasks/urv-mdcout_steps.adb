--  SPDX-License-Identifier: Apache-2.0

package body URV.MDCOUT_Steps with SPARK_Mode is

   procedure Add_Frame
     (Message : in out Downlink_Buffer; Frame : Frame_Words; Next : Piece) is
   begin
      Message (Error_Status) := With_Piece (Message (Error_Status), Next);
      Pack (Message, Frame);
   end Add_Frame;

end URV.MDCOUT_Steps;
