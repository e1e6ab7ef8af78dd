with Checks;              use Checks;
with Devices.CORE_Memory; use Devices.CORE_Memory;
with Expectations;        use Expectations;
with Task_Doubles;        use Task_Doubles;
with URVOS;               use URVOS;
with URV.CORE_Layout;     use URV.CORE_Layout;
with URV.CORE_Task;
with URV.Errors;          use URV.Errors;

package body CORE_Tests is

   --  The tests, in order.
   procedure Both_Are_New;
   procedure One_Is_New;
   procedure Codes;
   procedure Cold_Memory;

   --  The memory under the task, and how often each area was written.
   CORE            : Memory  := Cleared;
   Codes_Writes    : Natural := 0;
   Uplink_Writes   : Natural := 0;
   Downlink_Writes : Natural := 0;

   procedure Write_Codes
     (Uplink_Codes   : Uplink_Words;
      Downlink_Codes : Downlink_Words;
      Status_Codes   : Status_Words);
   procedure Write_Uplink (Words : Uplink_Words);
   procedure Write_Downlink (Words : Downlink_Words);

   --  Nothing written yet.
   procedure Begin_Test;

   package Under_Test is new URV.CORE_Task
     (Receive_Uplink   => Uplink.Receive,
      Receive_Downlink => Downlink.Receive,
      Write_Codes      => Write_Codes,
      Write_Uplink     => Write_Uplink,
      Write_Downlink   => Write_Downlink,
      Report           => Report);

   procedure Write_Codes
     (Uplink_Codes   : Uplink_Words;
      Downlink_Codes : Downlink_Words;
      Status_Codes   : Status_Words) is
   begin
      CORE.Status_Codes   := Status_Codes;
      CORE.Uplink_Codes   := Uplink_Codes;
      CORE.Downlink_Codes := Downlink_Codes;
      Codes_Writes        := Codes_Writes + 1;
   end Write_Codes;

   procedure Write_Uplink (Words : Uplink_Words) is
   begin
      CORE.Uplink   := Words;
      Uplink_Writes := Uplink_Writes + 1;
   end Write_Uplink;

   procedure Write_Downlink (Words : Downlink_Words) is
   begin
      CORE.Downlink   := Words;
      Downlink_Writes := Downlink_Writes + 1;
   end Write_Downlink;

   procedure Begin_Test is
   begin
      Clear;
      CORE            := Cleared;
      Codes_Writes    := 0;
      Uplink_Writes   := 0;
      Downlink_Writes := 0;
      Under_Test.Initialise;
   end Begin_Test;

   procedure Both_Are_New is
   begin
      Begin_Test;
      Uplink.Given   := Uplink_Of (16#100#);
      Downlink.Given := Downlink_Of (16#200#);
      Under_Test.Run_Transaction;
      for I in CORE.Uplink'Range loop
         Expect
           ("uplink word" & I'Image, CORE.Uplink (I),
            (if I = CORE.Uplink'Last then 0 else 16#100# + Word (I) - 1));
      end loop;
      for I in CORE.Downlink'Range loop
         Expect
           ("downlink word" & I'Image, CORE.Downlink (I),
            (if I = CORE.Downlink'Last then 0 else 16#200# + Word (I) - 1));
      end loop;
      Expect_Buffer
        ("read back", To_Buffer (CORE.Uplink), Uplink_Of (16#100#));
      Expect_Buffer
        ("read back", To_Buffer (CORE.Downlink), Downlink_Of (16#200#));
      Expect_Errors ("both new", None);
   end Both_Are_New;

   procedure One_Is_New is
   begin
      for Up_Is_New in Boolean loop
         for Down_Is_New in Boolean loop
            Both_Are_New;
            Uplink.Given      := Uplink_Of (16#300#);
            Uplink.Is_Fresh   := Up_Is_New;
            Downlink.Given    := Downlink_Of (16#400#);
            Downlink.Is_Fresh := Down_Is_New;
            Under_Test.Run_Transaction;
            Expect_Number
              ("uplink writes", Uplink_Writes,
               (if Up_Is_New then 2 else 1));
            Expect_Number
              ("downlink writes", Downlink_Writes,
               (if Down_Is_New then 2 else 1));
            Expect
              ("uplink", CORE.Uplink (1),
               (if Up_Is_New then 16#300# else 16#100#));
            Expect
              ("downlink", CORE.Downlink (1),
               (if Down_Is_New then 16#400# else 16#200#));
            Expect
              ("missing uplinks", Errors (CORE_No_Uplink),
               (if Up_Is_New then 0 else 1));
            Expect
              ("missing downlinks", Errors (CORE_No_Downlink),
               (if Down_Is_New then 0 else 1));
         end loop;
      end loop;
   end One_Is_New;

   procedure Codes is
      type Seen_Codes is array (Word) of Boolean;
      Seen : Seen_Codes := (others => False);
   begin
      Begin_Test;
      Uplink.Is_Fresh   := False;
      Downlink.Is_Fresh := False;
      for Run in 1 .. 3 loop
         Under_Test.Run_Transaction;
         Expect_Number ("writes of the codes", Codes_Writes, 1);
      end loop;

      --  Each item has a code of its own, and none has the cleared one.
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

      Under_Test.Initialise;
      Under_Test.Run_Transaction;
      Expect_Number ("writes after a start", Codes_Writes, 2);
   end Codes;

   procedure Cold_Memory is
   begin
      for Value of Cleared.Uplink loop
         Expect ("uplink", Value, 0);
      end loop;
      for Value of Cleared.Downlink loop
         Expect ("downlink", Value, 0);
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
        (Suite, "COR-1 what is not new is not written again",
         One_Is_New'Access);
      Add
        (Suite, "BUF-4 each item has a type code, INI-7 written once",
         Codes'Access);
      Add (Suite, "INI-6 cleared memory holds nothing", Cold_Memory'Access);
   end Add_To;

end CORE_Tests;
