--  SPDX-License-Identifier: Apache-2.0

with Checks;          use Checks;
with Expectations;    use Expectations;
with Task_Rig;        use Task_Rig;
with URVOS;           use URVOS;
with URV.Buffers;     use URV.Buffers;
with URV.CORE_Layout; use URV.CORE_Layout;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.CORE_Task;
with URV.Errors;      use URV.Errors;
with URV.Mailboxes;   use URV.Mailboxes;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors;

separate (Task_Suite)
package body CORE_Tests is

   --  The tests, in order.
   procedure Both_Are_New;
   procedure One_Is_New;
   procedure Codes;
   procedure Cold_Memory;

   --  The task's surroundings

   Uplink   : For_Uplink.Variable;
   Downlink : For_Framed_Downlink.Variable;
   Board    : URV.Shared_CORE_Memory.Board;
   Errors   : URV.Shared_Errors.Shared_Log;

   package Under_Test is new URV.CORE_Task
     (Uplink, Downlink, Board, Errors);

   --  Starts a test with an unwritten memory.
   procedure Begin_Test;

   procedure Begin_Test is
   begin
      Uplink.Reset;
      Downlink.Reset;
      Board.Clear;
      Errors.Clear;
      Under_Test.Initialise;
   end Begin_Test;

   procedure Both_Are_New is
      CORE : Memory;
   begin
      Begin_Test;
      Up.Give (Uplink, Uplink_Of (16#100#));
      Framed.Give (Downlink, Framed_Of (16#200#));
      Under_Test.Run_Transaction;
      CORE := Board.Contents;
      Expect_Buffer ("uplink", CORE.Uplink, Uplink_Of (16#100#));
      Expect_Buffer ("downlink", CORE.Downlink, Downlink_Of (16#200#));
      Expect_Errors ("both new", Errors, None);
   end Both_Are_New;

   procedure One_Is_New is

      --  Words that only another writer can have written.
      Foreign_Up   : constant Uplink_Buffer   := (others => 16#500#);
      Foreign_Down : constant Downlink_Buffer := (others => 16#600#);

      CORE : Memory;
   begin
      for Up_Is_New in Boolean loop
         for Down_Is_New in Boolean loop
            Both_Are_New;
            Board.Write_Uplink (Foreign_Up);
            Board.Write_Downlink (Foreign_Down, Unknown_Frame);
            if Up_Is_New then
               Up.Give (Uplink, Uplink_Of (16#300#));
            end if;
            if Down_Is_New then
               Framed.Give (Downlink, Framed_Of (16#400#));
            end if;
            Under_Test.Run_Transaction;
            CORE := Board.Contents;
            Expect
              ("uplink",
               CORE.Uplink =
                 (if Up_Is_New then Uplink_Of (16#300#)
                  else Foreign_Up),
               True);
            Expect
              ("downlink",
               CORE.Downlink =
                 (if Down_Is_New then Downlink_Of (16#400#)
                  else Foreign_Down),
               True);
            Expect_Errors
              ("missing", Errors,
               (if Up_Is_New and Down_Is_New then None
                elsif Up_Is_New then (1 => CORE_No_Downlink)
                elsif Down_Is_New then (1 => CORE_No_Uplink)
                else (CORE_No_Uplink, CORE_No_Downlink)));
         end loop;
      end loop;
   end One_Is_New;

   procedure Codes is
      type Seen_Codes is array (Word) of Boolean;
      Seen : Seen_Codes := (others => False);
      CORE : Memory;

      --  Runs a transaction over other codes, and expects whether it writes
      --  the codes.
      procedure Expect_Written (What : String; Expected : Boolean);

      procedure Expect_Written (What : String; Expected : Boolean) is
      begin
         Board.Write_Codes ((others => 1), (others => 2), (others => 3));
         Under_Test.Run_Transaction;
         CORE := Board.Contents;
         Expect
           (What,
            CORE.Uplink_Codes = Uplink_Type_Codes
            and then CORE.Downlink_Codes = Downlink_Type_Codes
            and then CORE.Status_Codes = Status_Type_Codes,
            Expected);
         Expect
           (What & ", left as they are",
            (for all Code of CORE.Uplink_Codes => Code = 1)
            and then (for all Code of CORE.Downlink_Codes => Code = 2)
            and then (for all Code of CORE.Status_Codes => Code = 3),
            not Expected);
      end Expect_Written;

   begin
      Begin_Test;
      Expect_Written ("written at first", True);

      --  Each item has its own code, and none has the cleared one.
      for Code of CORE.Uplink_Codes loop
         Expect ("code" & Code'Image & " is taken", Seen (Code), False);
         Seen (Code) := True;
      end loop;
      for Code of CORE.Downlink_Codes loop
         Expect ("code" & Code'Image & " is taken", Seen (Code), False);
         Seen (Code) := True;
      end loop;
      for Code of CORE.Status_Codes loop
         Expect ("code" & Code'Image & " is taken", Seen (Code), False);
         Seen (Code) := True;
      end loop;
      Expect
        ("first status code", CORE.Status_Codes (Start_Condition), 16#301#);
      Expect ("code of cleared memory is taken", Seen (0), False);

      for Run in 1 .. 2 loop
         Expect_Written ("not again", False);
      end loop;
      Under_Test.Initialise;
      Expect_Written ("after a start", True);
      Expect_Written ("and not again", False);
   end Codes;

   procedure Cold_Memory is
   begin
      --  SAF-5: no data has come.
      for Item in Uplink_Item loop
         Expect
           ("uplink", Cleared.Uplink (Item),
            (if Item = Error_Status then Stale_Data else 0));
      end loop;
      for Item in Downlink_Item loop
         Expect
           ("downlink", Cleared.Downlink (Item),
            (if Item = Error_Status then Stale_Data else 0));
      end loop;
      for Value of Cleared.Status loop
         Expect ("status", Value, 0);
      end loop;
      for Value of Cleared.Status_Codes loop
         Expect ("code", Value, 0);
      end loop;
      for Value of Cleared.Uplink_Codes loop
         Expect ("code", Value, 0);
      end loop;
      for Value of Cleared.Downlink_Codes loop
         Expect ("code", Value, 0);
      end loop;
   end Cold_Memory;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "COR-1 both buffers go to their areas, in order",
         Both_Are_New'Access);
      Add
        (Suite, "COR-1 old words are not written again",
         One_Is_New'Access);
      Add
        (Suite, "BUF-4 each item has a type code, INI-7 written once",
         Codes'Access);
      Add (Suite, "INI-6 cleared memory holds nothing", Cold_Memory'Access);
   end Add_To;

end CORE_Tests;
