--  SPDX-License-Identifier: Apache-2.0

package body URV.Shared_Status with SPARK_Mode is

   protected body Status is

      procedure Write (Bits : Word) is
      begin
         Item := Bits;
      end Write;

      procedure Add (Bits : Word) is
      begin
         Item := Item or Bits;
      end Add;

      function Contents return Word is (Item);

   end Status;

end URV.Shared_Status;
