--  SPDX-License-Identifier: Apache-2.0

with Interfaces.C; use Interfaces.C;

with Host.Complaints;

package body Host.Text_Input is

   --  The operating system: Linux. Without Without_Waiting the opening of a
   --  pipe would block until there is a writer.

   Without_Waiting : constant := 8#4_000#;
   Close_On_Exec   : constant := 8#2_000_000#;

   function Open (Name : char_array; Flags : int) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   --  From GNAT's run-time library; 0 when it is not a regular file.
   function Is_Regular_File (File : int) return int
   with Import, Convention => C,
        External_Name => "__gnat_is_regular_file_fd";

   Byte_Order_Mark : constant String :=
     Character'Val (16#EF#) & Character'Val (16#BB#)
     & Character'Val (16#BF#);

   --  Fills Block unless it holds data or the file has ended.
   procedure Fill (From : in out Reader);

   procedure Fill (From : in out Reader) is
      Length : Integer;
   begin
      if From.Next <= From.Last then
         return;
      end if;

      Length := Read (From.File, From.Block'Address, Block_Length);
      if Length < 0 then
         From.Number := From.Number + 1;
         Refuse (From, "cannot be read: " & Errno_Message);
      end if;
      From.Next := 1;
      From.Last := Length;
   end Fill;

   procedure Open (From : in out Reader; File : String) is
   begin
      From.Name   := To_Unbounded_String (File);
      From.Number := 0;
      From.Next   := 1;
      From.Last   := 0;
      From.File   :=
        File_Descriptor (Open (To_C (File), Without_Waiting + Close_On_Exec));
      if From.File = Invalid_FD then
         Refuse (From, "cannot be opened: " & Errno_Message);
      elsif Is_Regular_File (int (From.File)) = 0
        and then not Is_Directory (File)
      then
         Refuse (From, "is not a regular file");
      end if;

      Fill (From);
      if From.Last = 0 then
         Refuse (From, "the file is empty");
      end if;

      --  The first block of a file is shorter than the mark only if the file
      --  is.
      if From.Last >= Byte_Order_Mark'Length
        and then From.Block (1 .. Byte_Order_Mark'Length) = Byte_Order_Mark
      then
         From.Next := Byte_Order_Mark'Length + 1;
      end if;
   end Open;

   procedure Next_Line (From : in out Reader; Found : out Boolean) is
      Char : Character;
   begin
      From.Text_Length := 0;
      Fill (From);
      Found       := From.Next <= From.Last;
      From.Number := From.Number + 1;

      while From.Next <= From.Last loop
         Char      := From.Block (From.Next);
         From.Next := From.Next + 1;
         exit when Char = ASCII.LF;

         From.Text_Length := From.Text_Length + 1;
         From.Text (From.Text_Length) := Char;
         if From.Text_Length > Longest_Line then
            Refuse
              (From,
               "the line is longer than" & Longest_Line'Image
               & " characters");
         end if;

         if From.Next > From.Last then
            Fill (From);
         end if;
      end loop;

      if From.Text_Length > 0
        and then From.Text (From.Text_Length) = ASCII.CR
      then
         From.Text_Length := From.Text_Length - 1;
      end if;
   end Next_Line;

   procedure Refuse (From : Reader; Message : String) is
   begin
      Refuse (From, Line_Number (From), Message);
   end Refuse;

   procedure Refuse (From : Reader; Line : Positive; Message : String) is
   begin
      Complaints.Refuse (To_String (From.Name), Line, Message);
   end Refuse;

   procedure Close (From : in out Reader) is
   begin
      if From.File /= Invalid_FD then
         Close (From.File);
         From.File := Invalid_FD;
      end if;
   end Close;

   overriding procedure Finalize (From : in out Reader) is
   begin
      Close (From);
   end Finalize;

   function Trimmed (Text : String) return String is
      First : Positive := Text'First;
      Last  : Natural  := Text'Last;
   begin
      while First <= Last and then Text (First) in ' ' | ASCII.HT loop
         First := First + 1;
      end loop;
      while First <= Last and then Text (Last) in ' ' | ASCII.HT loop
         Last := Last - 1;
      end loop;
      return Text (First .. Last);
   end Trimmed;

end Host.Text_Input;
