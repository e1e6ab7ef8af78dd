--  SPDX-License-Identifier: Apache-2.0

package body URV.Buffers with SPARK_Mode is

   procedure Mark (This : in out Uplink_Buffer; Status : Word) is
   begin
      This (Error_Status) := This (Error_Status) or Status;
   end Mark;

   procedure Mark (This : in out Downlink_Buffer; Status : Word) is
   begin
      This (Error_Status) := This (Error_Status) or Status;
   end Mark;

end URV.Buffers;
