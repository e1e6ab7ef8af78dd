--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Shared_Data with SPARK_Mode is

   protected body Store is

      procedure Write (Item : Data) is
      begin
         Kept := Item;
      end Write;

      function Contents return Data is (Kept);

   end Store;

end URVOS.Shared_Data;
