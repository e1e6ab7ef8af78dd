--  SPDX-License-Identifier: Apache-2.0

package body URV.GDCIN_Steps with SPARK_Mode is

   procedure Pass_On (Item : in out Downlink_Buffer; Fresh : Boolean) is
   begin
      if not Fresh then
         Mark (Item, Stale_Data);
      end if;
   end Pass_On;

   procedure Take_Off (Message : in out Downlink_Buffer; Next : out Piece) is
   begin
      Next := Piece_Of (Message (Error_Status));
      Message (Error_Status) := Without_Piece (Message (Error_Status));
   end Take_Off;

end URV.GDCIN_Steps;
