--  SPDX-License-Identifier: Apache-2.0

with GNAT.OS_Lib; use GNAT.OS_Lib;

with Checks;                    use Checks;
with Expectations;              use Expectations;
with Host.Text_Output;          use Host.Text_Output;
with Partitions.Output_Buffers; use Partitions.Output_Buffers;

separate (Task_Suite)
package body Output_Buffers_Tests is

   --  The tests, in order.
   procedure In_Order_And_Whole;
   procedure The_Newest_Version;
   procedure Closed_When_Written;
   procedure A_Shorter_Version;

   --  Far too large for the stack.
   Item : array (1 .. 3) of Buffer;

   Text       : Block;
   Length     : Natural;
   Is_Version : Boolean;
   Is_Over    : Boolean;

   procedure In_Order_And_Whole is
      This : Buffer renames Item (1);

      --  A row's length such that rows end at every place of the buffer's end.
      Row_Length : constant := 997;

      --  Row number N consists of one character.
      function Mark (Number : Natural) return Character is
        (Character'Val (32 + Number mod 90));

      Is_Taken : Boolean;
      Is_Right : Boolean := True;
      Put      : Natural := 0;
      Came     : Natural := 0;
   begin
      for Go in 1 .. 5 loop
         loop
            This.Put ((1 .. Row_Length => Mark (Put)), Is_Taken);
            exit when not Is_Taken;
            Put := Put + 1;
         end loop;
         Expect
           ("it is full", Capacity - This.Waiting < Row_Length, True);

         --  Nearly all, each time.
         for Block in 1 .. Capacity / Block_Length - 1 loop
            This.Take (Text, Length, Is_Version, Is_Over);
            for Place in 1 .. Length loop
               Is_Right := Is_Right
                 and then Text (Place)
                          = Mark ((Came + Place - 1) / Row_Length);
            end loop;
            Came := Came + Length;
            This.Done;
         end loop;
         Expect ("all is right", Is_Right, True);
         Expect_Number
           ("what was taken and what waits is all",
            Came + This.Waiting, Put * Row_Length);
      end loop;
      Expect ("it is no version", Is_Version, False);
   end In_Order_And_Whole;

   procedure The_Newest_Version is
      This : Buffer renames Item (2);
   begin
      This.Replace ("first");
      This.Replace ("second one");
      This.Take (Text, Length, Is_Version, Is_Over);
      Expect ("the newest is taken", Text (1 .. Length) = "second one", True);
      Expect ("it is a version", Is_Version, True);
      Expect_Number
        ("it waits until it is written", This.Waiting, Length);

      --  An item that comes meanwhile waits for the next time.
      This.Replace ("third");
      This.Done;
      This.Take (Text, Length, Is_Version, Is_Over);
      Expect ("the next is taken", Text (1 .. Length) = "third", True);
      This.Done;
      This.Take (Text, Length, Is_Version, Is_Over);
      Expect_Number ("there is none", Length, 0);

      This.Replace ((1 .. Block_Length + 1 => 'x'));
      This.Take (Text, Length, Is_Version, Is_Over);
      Expect_Number ("a longer one is cut off", Length, Block_Length);
   end The_Newest_Version;

   procedure Closed_When_Written is
      This     : Buffer renames Item (3);
      Before   : constant Natural := This.Progress;
      Is_Taken : Boolean;
   begin
      This.Put ("last", Is_Taken);
      Expect ("it is taken", Is_Taken, True);
      This.Finish;
      This.Take (Text, Length, Is_Version, Is_Over);
      Expect ("the last comes", Text (1 .. Length) = "last", True);
      Expect ("nothing more comes", Is_Over, True);
      Expect ("it is not closed before", This.Is_Closed, False);
      This.Done;
      Expect ("what was written is progress", This.Progress > Before, True);
      This.Close;
      Expect ("it is closed", This.Is_Closed, True);
      Expect_Number ("nothing waits", This.Waiting, 0);
   end Closed_When_Written;

   procedure A_Shorter_Version is
      Versions : constant array (1 .. 3) of Positive := (7, 2, 9);
      To       : Writer;
      File     : File_Descriptor;
      Name     : Temp_File_Name;
      Deleted  : Boolean;

      --  The file's contents, as another program reads them.
      function Contents return String;

      function Contents return String is
         Reader : constant File_Descriptor := Open_Read (Name, Binary);
         Item   : String (1 .. 20);
         Count  : Integer;
      begin
         Count := Read (Reader, Item'Address, Item'Length);
         Close (Reader);
         return Item (1 .. Count);
      end Contents;

   begin
      Create_Temp_File (File, Name);
      Attach (To, File, "a test's file", Is_Rewritten => True);
      for Length of Versions loop
         Restart (To);
         Put (To, (1 .. Length => 'x'));
         End_Version (To);
         Expect
           ("the file is the version of" & Length'Image & " characters",
            Contents = (1 .. Length => 'x'), True);
      end loop;
      Restart (To);
      Put (To, "end");
      Close (To);
      Expect ("so it is when closed", Contents = "end", True);
      Expect ("nothing is lost", Is_Lost (To), False);
      Delete_File (Name, Deleted);
      Expect ("the test leaves nothing", Deleted, True);
   end A_Shorter_Version;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add (Suite, "RTP-10 rows wait in their order, whole or not at all",
           In_Order_And_Whole'Access);
      Add (Suite, "RTP-10 of an output's versions the newest is written",
           The_Newest_Version'Access);
      Add (Suite, "RTP-10 an output is closed when all of it is written",
           Closed_When_Written'Access);
      Add (Suite, "RTP-10 a shorter version leaves nothing of a longer one",
           A_Shorter_Version'Access);
   end Add_To;

end Output_Buffers_Tests;
