--  SPDX-License-Identifier: Apache-2.0

with Host.Complaints;

package body Host.Text_Output is

   use type Text_Numbers.Number;

   --  The digits of the numbers below 100.
   type Two_Digits is range 0 .. 99;
   type Digit_Table is array (Two_Digits) of Character;
   Ten_Digits : constant String := "0123456789";
   Tens, Ones : Digit_Table;

   function Truncate
     (File   : GNAT.OS_Lib.File_Descriptor;
      Length : Long_Long_Integer) return Integer
     with Import, Convention => C, External_Name => "ftruncate64";

   procedure Refuse (To : Writer) with No_Return;

   procedure Refuse (To : Writer) is
   begin
      Complaints.Give_Up
        (To_String (To.Title) & " cannot be written: "
         & GNAT.OS_Lib.Errno_Message);
   end Refuse;

   procedure Flush (To : in out Writer) is
      First   : Positive := 1;
      Written : Integer;
   begin
      while First <= To.Last loop
         Written :=
           GNAT.OS_Lib.Write
             (To.File, To.Block (First)'Address, To.Last - First + 1);
         if Written <= 0 then
            --  A second try, when the writer is closed, would fail too.
            To.Last := 0;
            Refuse (To);
         end if;
         First := First + Written;
         To.Length := To.Length + Long_Long_Integer (Written);
      end loop;
      To.Last := 0;
   end Flush;

   procedure Restart (To : in out Writer) is
   begin
      To.Last    := 0;
      To.Longest := Long_Long_Integer'Max (To.Longest, To.Length);
      To.Length  := 0;
      GNAT.OS_Lib.Lseek (To.File, 0, GNAT.OS_Lib.Seek_Set);
   end Restart;

   procedure End_Version (To : in out Writer) is
      Missing : constant Long_Long_Integer :=
        To.Longest - To.Length - Long_Long_Integer (To.Last);
   begin
      for Blank in 1 .. Missing loop
         Put (To, ' ');
      end loop;
      Flush (To);
   end End_Version;

   procedure Attach
     (To           : in out Writer;
      File         : GNAT.OS_Lib.File_Descriptor;
      Title        : String;
      Is_Rewritten : Boolean := False) is
   begin
      To.File         := File;
      To.Title        := To_Unbounded_String (Title);
      To.Last         := 0;
      To.Length       := 0;
      To.Longest      := 0;
      To.Is_Rewritten := Is_Rewritten;
   end Attach;

   function Screen (Is_Error : Boolean := False)
                    return GNAT.OS_Lib.File_Descriptor
   is
      use GNAT.OS_Lib;

      function Duplicate (File : File_Descriptor) return File_Descriptor
        with Import, Convention => C, External_Name => "dup";
   begin
      return Duplicate (if Is_Error then Standerr else Standout);
   end Screen;

   procedure Attach_Screen (To : in out Writer; Is_Error : Boolean := False)
   is
      Title : constant String :=
        (if Is_Error then "standard error" else "standard output");
      File  : constant GNAT.OS_Lib.File_Descriptor := Screen (Is_Error);
   begin
      if File = GNAT.OS_Lib.Invalid_FD then
         To.Title := To_Unbounded_String (Title);
         Refuse (To);
      end if;
      Attach (To, File, Title);
   end Attach_Screen;

   procedure Put (To : in out Writer; Char : Character) is
   begin
      if To.Last = Block_Length then
         Flush (To);
      end if;
      To.Last := To.Last + 1;
      To.Block (To.Last) := Char;
   end Put;

   procedure Put (To : in out Writer; Text : String) is
   begin
      if Text'Length <= Block_Length - To.Last then
         To.Block (To.Last + 1 .. To.Last + Text'Length) := Text;
         To.Last := To.Last + Text'Length;
      else
         for Char of Text loop
            Put (To, Char);
         end loop;
      end if;
   end Put;

   procedure Put (To : in out Writer; Value : Text_Numbers.Number) is
      Most_Digits : constant := 20;
      Image       : String (1 .. Most_Digits);
      First       : Positive := Most_Digits + 1;
      Rest        : Text_Numbers.Number := Value;
      Pair        : Two_Digits;
   begin
      --  Two digits at a time, for a division costs more than a look-up.
      while Rest >= 10 loop
         Pair := Two_Digits (Rest mod 100);
         Rest := Rest / 100;
         Image (First - 1) := Ones (Pair);
         Image (First - 2) := Tens (Pair);
         First := First - 2;
      end loop;
      if Rest > 0 or else Value = 0 then
         First := First - 1;
         Image (First) := Ones (Two_Digits (Rest));
      end if;

      if Block_Length - To.Last < Most_Digits then
         Flush (To);
      end if;
      for Digit of Image (First .. Most_Digits) loop
         To.Last := To.Last + 1;
         To.Block (To.Last) := Digit;
      end loop;
   end Put;

   procedure New_Line (To : in out Writer) is
   begin
      Put (To, ASCII.LF);
   end New_Line;

   procedure Put_Line (To : in out Writer; Text : String) is
   begin
      Put (To, Text);
      New_Line (To);
   end Put_Line;

   procedure Put
     (To       : in out Writer;
      Value    : Long_Float;
      Decimals : Positive)
   is
      Largest : constant := 1.0E12;
      Units   : constant Text_Numbers.Number := 10 ** Decimals;
      Rounded : Text_Numbers.Number;
      Unit    : Text_Numbers.Number := Units;
   begin
      --  Written so that what is not a number is not inside either.
      if not (abs Value <= Largest) then
         Put (To, "nan");
         return;
      end if;

      Rounded := Text_Numbers.Number (abs Value * Long_Float (Units));
      if Value < 0.0 and then Rounded > 0 then
         Put (To, '-');
      end if;
      Put (To, Rounded / Units);
      Put (To, '.');
      for Place in 1 .. Decimals loop
         Unit := Unit / 10;
         Put (To, Rounded / Unit mod 10);
      end loop;
   end Put;

   procedure Close (To : in out Writer) is
      File   : constant GNAT.OS_Lib.File_Descriptor := To.File;
      Closed : Boolean;
   begin
      if not Is_Open (To) then
         return;
      end if;

      Flush (To);
      To.File := GNAT.OS_Lib.Invalid_FD;
      if To.Longest > To.Length and then Truncate (File, To.Length) /= 0 then
         Refuse (To);
      end if;
      GNAT.OS_Lib.Close (File, Closed);
      if not Closed then
         Refuse (To);
      end if;
   end Close;

begin
   for Pair in Two_Digits loop
      Tens (Pair) := Ten_Digits (Integer (Pair) / 10 + 1);
      Ones (Pair) := Ten_Digits (Integer (Pair) mod 10 + 1);
   end loop;
end Host.Text_Output;
