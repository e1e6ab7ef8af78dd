--  SPDX-License-Identifier: Apache-2.0

--  Tries of the sealed link (docs/security.md).
--
--     urv_seal tries NUMBER SEED   blocks of one who has no key, and what
--                                  became of them
--     urv_seal tags                for each line of standard input, a key and
--                                  a message in hexadecimal, its tag
--
--  Exit status: 0 none was taken, 1 one was, 2 a bad command line or input.

with Ada.Command_Line; use Ada.Command_Line;
with Ada.Text_IO;      use Ada.Text_IO;
with Interfaces;       use Interfaces;

with Seal_Tries;   use Seal_Tries;
with URV.Handshakes;  use URV.Handshakes;
with URV.Sip_Hash; use URV.Sip_Hash;
with URVOS;        use URVOS;

procedure Urv_Seal is

   procedure Print_Tags;
   procedure Print_Tries (Number, Seed : Total);

   --  The byte that two digits say.
   function Byte_At (Line : String; Place : Positive) return Byte is
     (Byte'Value ("16#" & Line (Place .. Place + 1) & "#"));

   procedure Print_Tags is
      Key_Digits : constant := 32;
      Item       : Message;
      Half       : array (1 .. 2) of Unsigned_64;
   begin
      while not End_Of_File loop
         declare
            Line : constant String := Get_Line;
         begin
            for Which in Half'Range loop
               Half (Which) := 0;
               for Place in reverse 8 * Which - 7 .. 8 * Which loop
                  Half (Which) := Shift_Left (Half (Which), 8)
                    or Unsigned_64 (Byte_At (Line, 2 * Place - 1));
               end loop;
            end loop;
            Item.Length :=
              Message_Length
                (Integer'Max (0, (Line'Length - Key_Digits - 1) / 2));
            for Place in 1 .. Item.Length loop
               Item.Bytes (Place) :=
                 Byte_At (Line, Key_Digits + 2 * Integer (Place));
            end loop;
            Put_Line (Tag (Item, (Half (1), Half (2)))'Image);
         end;
      end loop;
   end Print_Tags;

   procedure Print_Tries (Number, Seed : Total) is
      Found : Results;
      Sum   : Total := 0;
   begin
      Try (Number, Seed, Found);
      for Kind in Attack loop
         for What in Outcome loop
            if Found (Kind, What) > 0 then
               Put_Line
                 (Kind'Image & ' ' & What'Image & Found (Kind, What)'Image);
            end if;
            if What in Taken | Hello_Taken then
               Sum := Sum + Found (Kind, What);
            end if;
         end loop;
      end loop;
      Put_Line (Number'Image & " tries," & Sum'Image & " taken");
      if Sum > 0 then
         Set_Exit_Status (1);
      end if;
   end Print_Tries;

begin
   if Argument_Count = 1 and then Argument (1) = "tags" then
      Print_Tags;
   elsif Argument_Count = 3 and then Argument (1) = "tries" then
      Print_Tries (Total'Value (Argument (2)), Total'Value (Argument (3)));
   else
      Put_Line
        (Standard_Error,
         "urv_seal: there are ""tags"" and ""tries NUMBER SEED""");
      Set_Exit_Status (2);
   end if;
exception
   when Constraint_Error =>
      Put_Line (Standard_Error, "urv_seal: that is no number");
      Set_Exit_Status (2);
end Urv_Seal;
