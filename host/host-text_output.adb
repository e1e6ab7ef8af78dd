--  SPDX-License-Identifier: Apache-2.0

with System.Storage_Elements;

with Host.Complaints;

package body Host.Text_Output is

   use type GNAT.OS_Lib.File_Descriptor;
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

   function Synchronise_Data
     (File : GNAT.OS_Lib.File_Descriptor) return Integer
     with Import, Convention => C, External_Name => "fdatasync";

   --  The assumed error when the system gives no reason.
   Input_Output_Error : constant := 5;

   --  For the whole program.
   Has_Lost : Boolean := False with Atomic;

   --  Closes the output after a failed system call.
   procedure Lose (To : in out Writer);

   --  Ends the file there; nothing of a longer previous version is left.
   procedure Shorten (To : in out Writer; Length : Long_Long_Integer);

   function Any_Lost return Boolean is (Has_Lost);

   function Loss (To : Writer) return String is
     (GNAT.OS_Lib.Errno_Message (To.Error));

   procedure Lose (To : in out Writer) is
      Unused_Closed : Boolean;
   begin
      To.Error := GNAT.OS_Lib.Errno;
      if To.Error = 0 then
         To.Error := Input_Output_Error;
      end if;
      To.State := Lost;
      To.Last := 0;
      Has_Lost := True;
      if To.File /= GNAT.OS_Lib.Invalid_FD then
         GNAT.OS_Lib.Close (To.File, Unused_Closed);
         To.File := GNAT.OS_Lib.Invalid_FD;
      end if;
      Complaints.Report
        (To_String (To.Title) & " cannot be written: " & Loss (To));
   end Lose;

   procedure Flush (To : in out Writer) is
      First : Positive := 1;
      Count : Integer;
   begin
      while First <= To.Last and then To.State = Written loop
         Count :=
           GNAT.OS_Lib.Write
             (To.File, To.Block (First)'Address, To.Last - First + 1);
         if Count <= 0 then
            Lose (To);
            return;
         end if;
         First := First + Count;
         To.Length := To.Length + Long_Long_Integer (Count);
      end loop;
      To.Last := 0;
   end Flush;

   procedure Synchronise (To : in out Writer) is
      Unused_Result : Integer;   --  an error for a pipe, or a device
   begin
      if To.State = Written then
         Unused_Result := Synchronise_Data (To.File);
      end if;
   end Synchronise;

   procedure Restart (To : in out Writer) is
   begin
      To.Last    := 0;
      To.Longest := Long_Long_Integer'Max (To.Longest, To.Length);
      To.Length  := 0;
      if To.State = Written then
         GNAT.OS_Lib.Lseek (To.File, 0, GNAT.OS_Lib.Seek_Set);
      end if;
   end Restart;

   procedure Shorten (To : in out Writer; Length : Long_Long_Integer) is
   begin
      if To.State = Written and then To.Longest > Length then
         if Truncate (To.File, Length) = 0 then
            To.Length  := Length;
            To.Longest := Length;
         else
            Lose (To);
         end if;
      end if;
   end Shorten;

   procedure End_Version (To : in out Writer) is
      Length : constant Long_Long_Integer :=
        To.Length + Long_Long_Integer (To.Last);
   begin
      --  Until the file is shortened, blanks replace the rest of the previous
      --  version.
      for Blank in Length + 1 .. To.Longest loop
         exit when Is_Lost (To);
         Put (To, ' ');
      end loop;
      Flush (To);
      Shorten (To, Length);
   end End_Version;

   procedure Attach
     (To           : in out Writer;
      File         : GNAT.OS_Lib.File_Descriptor;
      Title        : String;
      Is_Rewritten : Boolean := False) is
   begin
      To.State        := Written;
      To.Error        := 0;
      To.File         := File;
      To.Title        := To_Unbounded_String (Title);
      To.Last         := 0;
      To.Length       := 0;
      To.Longest      := 0;
      To.Is_Rewritten := Is_Rewritten;
   end Attach;

   procedure Attach_Memory (To : in out Writer) is
   begin
      To.State := In_Memory;
      To.Last  := 0;
   end Attach_Memory;

   procedure Clear (To : in out Writer) is
   begin
      To.Last := 0;
   end Clear;

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
      Attach (To, File, Title);
      if File = GNAT.OS_Lib.Invalid_FD then
         Lose (To);
      end if;
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
      --  Two digits at a time, because a division costs more than a look-up.
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
      --  Written so that not-a-number fails the test.
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
      Is_Closed : Boolean;
   begin
      if Is_Open (To) then
         Flush (To);
      end if;
      Shorten (To, To.Length);
      if To.State = Written then
         GNAT.OS_Lib.Close (To.File, Is_Closed);
         To.File := GNAT.OS_Lib.Invalid_FD;
         if not Is_Closed then
            Lose (To);
         end if;
      end if;
      To.State := Closed;
   end Close;

   --  A pipe without a reader, and a file at the user's size limit, then fail
   --  like any other output. By default they end the program silently.
   procedure Ignore_Signals;

   procedure Ignore_Signals is
      Broken_Pipe_Signal : constant := 13;
      File_Limit_Signal  : constant := 25;

      Ignored : constant System.Address :=
        System.Storage_Elements.To_Address (1);

      function Set
        (Signal : Integer; To : System.Address) return System.Address
        with Import, Convention => C, External_Name => "signal";

      Unused : System.Address;
   begin
      Unused := Set (Broken_Pipe_Signal, Ignored);
      Unused := Set (File_Limit_Signal, Ignored);
   end Ignore_Signals;

begin
   for Pair in Two_Digits loop
      Tens (Pair) := Ten_Digits (Integer (Pair) / 10 + 1);
      Ones (Pair) := Ten_Digits (Integer (Pair) mod 10 + 1);
   end loop;
   Ignore_Signals;
end Host.Text_Output;
