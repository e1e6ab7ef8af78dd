--  SPDX-License-Identifier: Apache-2.0

--  Input files of orders, one a line: words between blanks. "#" begins a
--  comment.

with Host.Text_Input; use Host.Text_Input;

package Host.Orders is

   --  Reads the file and passes each line that has more than a comment to
   --  Read, without the comment.
   generic
      with procedure Read (From : Reader; Order : String);
   procedure Read_All (File : String);

   function Word_Count (Order : String) return Natural;

   --  The word of that number, empty after the last.
   function Word (Order : String; Number : Positive) return String;

end Host.Orders;
