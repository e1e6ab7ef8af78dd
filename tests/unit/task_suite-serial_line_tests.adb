--  SPDX-License-Identifier: Apache-2.0

with Checks;                 use Checks;
with Expectations;           use Expectations;
with Partitions.Error_Marks; use Partitions.Error_Marks;
with URVOS;                  use URVOS;

separate (Task_Suite)
package body Serial_Line_Tests is

   --  The tests, in order.
   procedure Well_Received;
   procedure Marked;

   Reader : Mark_Reader;

   --  The device gives a byte. Completes: it completes a character. Wrong:
   --  that character was badly received.
   procedure Give (Data : Byte; Completes : Boolean; Wrong : Boolean);

   procedure Give (Data : Byte; Completes : Boolean; Wrong : Boolean) is
      Found        : Boolean;
      Parity_Error : Boolean;
   begin
      Take (Reader, Data, Found, Parity_Error);
      Expect ("completes" & Data'Image, Found, Completes);
      if Completes then
         Expect ("parity error of" & Data'Image, Parity_Error, Wrong);
      end if;
   end Give;

   procedure Well_Received is
   begin
      for Data in Byte range 0 .. 16#FE# loop
         Give (Data, Completes => True, Wrong => False);
      end loop;
      for Times in 1 .. 3 loop
         Give (16#FF#, Completes => False, Wrong => False);
         Give (16#FF#, Completes => True, Wrong => False);
      end loop;
      Give (16#00#, Completes => True, Wrong => False);
   end Well_Received;

   procedure Marked is
   begin
      for Data in Byte loop
         Give (16#FF#, Completes => False, Wrong => False);
         Give (16#00#, Completes => False, Wrong => False);
         Give (Data, Completes => True, Wrong => True);
         Give (16#4B#, Completes => True, Wrong => False);
      end loop;
   end Marked;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "RTP-1 a well received character is itself",
         Well_Received'Access);
      Add
        (Suite, "RTP-1 a wrong parity bit is reported",
         Marked'Access);
   end Add_To;

end Serial_Line_Tests;
