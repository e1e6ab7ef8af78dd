--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Ceilings with SPARK_Mode is

   protected body Box is
      procedure Put (Item : Word) is
      begin
         Contents := Item;
      end Put;
   end Box;

   task body Writer is
   begin
      loop
         Box.Put (1);
      end loop;
   end Writer;

   task body Once is
   begin
      null;
   end Once;

end Canaries.Ceilings;
