--  SPDX-License-Identifier: Apache-2.0

with URV.Type_Codes; use URV.Type_Codes;

package body Host.Recordings is

   procedure Put_Word (To : in out Writer; Value : Word);

   procedure Put_Word (To : in out Writer; Value : Word) is
      Digit_Of : constant array (Word range 0 .. 15) of Character :=
        "0123456789abcdef";
   begin
      Put (To, Digit_Of (Value / 4_096));
      Put (To, Digit_Of (Value / 256 mod 16));
      Put (To, Digit_Of (Value / 16 mod 16));
      Put (To, Digit_Of (Value mod 16));
   end Put_Word;

   function Length_Of (Time : Microseconds) return Ring_Length is
     (Ring_Length
        (Microseconds'Min
           (Microseconds'Max (Time / Major_Frame, 1),
            Microseconds (Ring_Length'Last))));

   procedure Put_Row (To : in out Writer; Item : Row) is
   begin
      for Place in Row_Word loop
         Put_Word (To, Word_At (Item, Place));
      end loop;
      New_Line (To);
   end Put_Row;

   procedure Put_Block (To : in out Writer; Item : Downlink_Buffer) is
   begin
      Put_Word (To, Kind_Of (Item));
      for Name in Sensor_Item loop
         Put_Word (To, Item (Name));
      end loop;
      New_Line (To);
   end Put_Block;

   package body Followers is

      Next     : Row_Number := 0;
      Is_Begun : Boolean := False;

      procedure Put_New_Rows (To : in out Writer) is
         Kept : constant Ring := Contents;
         Last : Row_Number;
      begin
         if not Is_Begun or else Kept.Next < Next then
            Put_Line (To, Title);
            Is_Begun := True;
            Next := 0;
         end if;
         Next := Row_Number'Max (Next, First (Kept));
         Last := Row_Number'Min (Kept.Next, Next + Most);
         while Next < Last loop
            Put_Row (To, Row_At (Next));
            Next := Next + 1;
         end loop;
      end Put_New_Rows;

   end Followers;

end Host.Recordings;
