--  SPDX-License-Identifier: Apache-2.0

with GNAT.OS_Lib;
with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with System;

with Host.Complaints;   use Host.Complaints;
with Host.File_States;  use Host.File_States;
with Host.Text_Numbers; use Host.Text_Numbers;
with URV.Sip_Hash; use type URV.Sip_Hash.Key;

package body Host.Key_Files is

   --  The operating system: Linux.

   Failed : constant := -1;

   function Open (Name : char_array; Flags : int) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   function Read
     (From : int; Buffer : System.Address; Length : size_t) return long
   with Import, Convention => C, External_Name => "read";

   function Close (This : int) return int
   with Import, Convention => C, External_Name => "close";

   --  Close on exec, do not wait for a writer, do not become a controlling
   --  terminal.
   Open_Flags : constant := 8#2_000_000# + 8#4_000# + 8#400#;

   function Effective_User return Unsigned_32
   with Import, Convention => C, External_Name => "geteuid";

   Owners_Alone : constant := 8#600#;

   function Random (Buffer : System.Address; Length : size_t; Flags : unsigned)
                    return long
   with Import, Convention => C, External_Name => "getrandom";

   function Control_Process (Operation : int; Value : unsigned_long) return int
   with Import, Convention => C_Variadic_1, External_Name => "prctl";

   Set_Dumpable : constant := 4;

   type Limits is array (1 .. 2) of unsigned_long with Convention => C;

   function Set_Limit (Operation : int; To : Limits) return int
   with Import, Convention => C, External_Name => "setrlimit";

   Core_Size : constant := 4;

   --  More than a key file needs.
   Longest : constant := 4_096;

   --  Prevents core dumps, and other processes from reading this memory.
   procedure Protect_Memory;

   --  Four octal digits.
   function Octal (Mode : Unsigned_16) return String;

   --  The descriptor of the file, if only its owner can access it.
   function Opened (Name : String) return int;

   --  Reads a line of the file.
   procedure Take
     (Name   : String;
      Number : Positive;
      Line   : String;
      Into   : in out Key_List);

   procedure Check (Format : Format_Number; Has_Key : Boolean) is
   begin
      if Format = 2 and then not Has_Key then
         Refuse
           ("--format 2 needs --key FILE; ""bin/urv keygen FILE"" makes one");
      elsif Format = 1 and then Has_Key then
         Refuse ("--key is of no use without --format 2");
      end if;
   end Check;

   procedure Protect_Memory is
   begin
      if Control_Process (Set_Dumpable, 0) = Failed
        or else Set_Limit (Core_Size, (0, 0)) = Failed
      then
         Refuse ("--key: this process cannot be kept from dumping core");
      end if;
   end Protect_Memory;

   function Octal (Mode : Unsigned_16) return String is
      Result : String (1 .. 4);
      Left   : Unsigned_16 := Mode;
   begin
      for Place in reverse Result'Range loop
         Result (Place) :=
           Character'Val (Character'Pos ('0') + Natural (Left mod 8));
         Left := Left / 8;
      end loop;
      return Result;
   end Octal;

   function Opened (Name : String) return int is
      File   : constant int := Open (To_C (Name), Open_Flags);
      Status : State;
      Found  : Boolean := False;
      Unused : int;
   begin
      if File = Failed then
         Refuse (Name, 1, "cannot be read: " & GNAT.OS_Lib.Errno_Message);
      end if;
      Read (File, Found, Status);
      if not Found then
         Refuse (Name, 1, "its mode cannot be read");
      elsif not Is_Regular (Status) then
         Unused := Close (File);
         Refuse (Name, 1, "is not a file");
      elsif Status.User /= Effective_User then
         Unused := Close (File);
         Refuse (Name, 1, "belongs to another user");
      elsif (Status.Mode and not Kind_Bits) /= Owners_Alone then
         Unused := Close (File);
         Refuse
           (Name, 1,
            "has mode " & Octal (Status.Mode and not Kind_Bits)
            & "; keys must have 0600");
      end if;
      return File;
   end Opened;

   procedure Take
     (Name   : String;
      Number : Positive;
      Line   : String;
      Into   : in out Key_List)
   is
      Digits_Of_Half : constant := 16;

      First    : Positive := Line'First;
      Last     : Natural;
      Part     : Natural := 0;
      Of_Key   : Text_Numbers.Number := 0;
      Half     : array (1 .. 2) of Text_Numbers.Number := (0, 0);
      Is_Valid : Boolean := True;
      Value    : URV.Sip_Hash.Key;

      --  The low byte of a half comes first in the file.
      function Swapped (Item : Unsigned_64) return Unsigned_64;

      function Swapped (Item : Unsigned_64) return Unsigned_64 is
         Result : Unsigned_64 := 0;
      begin
         for Place in 0 .. 7 loop
            Result := Shift_Left (Result, 8)
              or (Shift_Right (Item, 8 * Place) and 16#FF#);
         end loop;
         return Result;
      end Swapped;

      procedure Refuse_Line (Operation : String) with No_Return;

      procedure Refuse_Line (Operation : String) is
      begin
         Refuse (Name, Number, Operation);
      end Refuse_Line;

   begin
      --  A carriage return within a line would show as a line end elsewhere.
      if (for some Place in Line'First .. Line'Last - 1 =>
            Line (Place) = ASCII.CR)
      then
         Refuse_Line ("a carriage return that ends no line");
      end if;

      --  The parts between blanks: the word, the number, the digits.
      loop
         while First <= Line'Last and then Line (First) in ' ' | ASCII.HT
         loop
            First := First + 1;
         end loop;
         exit when First > Line'Last or else Line (First) = '#'
           or else Line (First) = ASCII.CR;

         Last := First;
         while Last < Line'Last
           and then Line (Last + 1) not in ' ' | ASCII.HT | '#' | ASCII.CR
         loop
            Last := Last + 1;
         end loop;
         Part := Part + 1;
         case Part is
            when 1 =>
               Is_Valid := Line (First .. Last) = "key";
            when 2 =>
               Read_Whole (Line (First .. Last), Of_Key, Is_Valid);
               Is_Valid := Is_Valid and then Of_Key <= 255;
            when 3 =>
               Is_Valid := Last - First + 1 = 2 * Digits_Of_Half
                 and then
                   (for all Each of Line (First .. Last) =>
                      Each in '0' .. '9' | 'a' .. 'f' | 'A' .. 'F');
               for Which in Half'Range loop
                  exit when not Is_Valid;
                  Read_Hexadecimal
                    (Line (First + (Which - 1) * Digits_Of_Half
                           .. First + Which * Digits_Of_Half - 1),
                     Half (Which), Is_Valid);
               end loop;
            when others =>
               Is_Valid := False;
         end case;
         exit when not Is_Valid;
         First := Last + 1;
      end loop;

      if Part = 0 then
         return;
      elsif not Is_Valid or else Part /= 3 then
         Refuse_Line
           ("this is not ""key"", a number from 0 to 255 and 32 hexadecimal"
            & " digits");
      end if;

      Value := (K0 => Swapped (Half (1)), K1 => Swapped (Half (2)));
      if Into (Second).Is_Present then
         Refuse_Line ("a third key; two at most may be valid");
      elsif Is_Known (Into, Key_Number (Of_Key)) then
         Refuse_Line ("the second key has the number of the first");
      elsif Value = No_Key then
         Refuse_Line ("a key of zeros is not allowed");
      elsif Into (URV.Sessions.First).Is_Present then
         Into (Second) := (True, Key_Number (Of_Key), Value);
      else
         Into (URV.Sessions.First) := (True, Key_Number (Of_Key), Value);
      end if;
      Half  := (0, 0);
      Value := No_Key;
      pragma Inspection_Point (Half, Value);
   end Take;

   procedure Load (Ring : in out Key_Ring; Name : String) is
      Text   : String (1 .. Longest) := (others => ' ') with Volatile;
      File   : int;
      Length : long;
      Unused : int;
      Begins : Positive := 1;
      Number : Positive := 1;

      procedure Wipe;

      procedure Wipe is
      begin
         for Each of Text loop
            Each := ' ';
         end loop;
      end Wipe;

   begin
      Protect_Memory;
      File := Opened (Name);
      Length := Read (File, Text'Address, Longest);
      Unused := Close (File);
      if Length = Failed then
         Refuse (Name, 1, "cannot be read: " & GNAT.OS_Lib.Errno_Message);
      elsif Length = Longest then
         Refuse (Name, 1, "is too long for a file of keys");
      end if;

      for Place in 1 .. Natural (Length) + 1 loop
         if Place > Natural (Length) or else Text (Place) = ASCII.LF then
            Take (Name, Number, Text (Begins .. Place - 1), Ring.Keys);
            Begins := Place + 1;
            Number := Number + 1;
         end if;
      end loop;
      Wipe;
      if not Ring.Keys (URV.Sessions.First).Is_Present then
         Refuse (Name, 1, "has no key; bin/urv keygen makes one");
      end if;
   exception
      when others =>
         Wipe;
         raise;
   end Load;

   procedure Hand_Over (Ring : in out Key_Ring) is
   begin
      Receive (Ring.Keys);
      Ring.Keys := (others => (others => <>));
      pragma Inspection_Point (Ring);
   end Hand_Over;

   function Random_Nonce return Nonce is
      Result : Unsigned_64 := 0;
   begin
      if Random (Result'Address, 8, 0) /= 8 then
         Refuse ("--key: there are no random numbers");
      end if;
      return Nonce (Result);
   end Random_Nonce;

end Host.Key_Files;
