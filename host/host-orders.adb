--  SPDX-License-Identifier: Apache-2.0

package body Host.Orders is

   subtype Blank is Character
     with Static_Predicate => Blank in ' ' | ASCII.HT;

   --  Skips a word and the blanks before it. There is none when First is after
   --  the end.
   procedure Next_Word
     (Order : String;
      First : in out Positive;
      Last  : in out Natural);

   procedure Next_Word
     (Order : String;
      First : in out Positive;
      Last  : in out Natural) is
   begin
      First := Last + 1;
      while First <= Order'Last and then Order (First) in Blank loop
         First := First + 1;
      end loop;
      Last := First - 1;
      while Last < Order'Last and then Order (Last + 1) not in Blank loop
         Last := Last + 1;
      end loop;
   end Next_Word;

   function Word_Count (Order : String) return Natural is
      First : Positive := Order'First;
      Last  : Natural  := Order'First - 1;
   begin
      return Count : Natural := 0 do
         loop
            Next_Word (Order, First, Last);
            exit when First > Order'Last;
            Count := Count + 1;
         end loop;
      end return;
   end Word_Count;

   function Word (Order : String; Number : Positive) return String is
      First : Positive := Order'First;
      Last  : Natural  := Order'First - 1;
   begin
      for Each in 1 .. Number loop
         Next_Word (Order, First, Last);
      end loop;
      return Order (First .. Last);
   end Word;

   procedure Read_All (File : String) is
      From  : Reader;
      Found : Boolean;
   begin
      Open (From, File);
      loop
         Next_Line (From, Found);
         exit when not Found;

         declare
            Text : constant String := Line (From);
            Last : Natural := Text'First - 1;
         begin
            while Last < Text'Last and then Text (Last + 1) /= '#' loop
               Last := Last + 1;
            end loop;

            declare
               Order : constant String :=
                 Trimmed (Text (Text'First .. Last));
            begin
               if Order /= "" then
                  Read (From, Order);
               end if;
            end;
         end;
      end loop;
   end Read_All;

end Host.Orders;
