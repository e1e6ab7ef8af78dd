--  SPDX-License-Identifier: Apache-2.0

with Checks;           use Checks;
with Expectations;     use Expectations;
with URVOS;            use URVOS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Receive_Calls;
with URVOS.Shared_Mailboxes;
with URVOS.Waits;      use URVOS.Waits;
with Waiting_Rig;      use Waiting_Rig;

separate (Kernel_Suite)
package body Receive_Calls_Tests is

   --  The tests, in order.
   procedure Quiet_Looks;
   procedure No_Wait;
   procedure At_Once;
   procedure In_Vain;
   procedure At_Any_Exit;
   procedure Many_Misses;
   procedure In_Steps;
   procedure Stopped_Clock;
   procedure End_Of_Time;
   procedure Back_In_Time;
   procedure Any_Clock;

   Neutral : constant Word := 16#800#;

   package Messages is new URVOS.Shared_Mailboxes (Word, Neutral);

   Variable : Messages.Variable;

   package Calls is new URVOS.Receive_Calls (Messages, Variable);

   --  The number of looks of RECV.
   Looked : Count := 0;

   --  RECV in steps, with an EXIT between two steps.
   procedure Receive_Within
     (Ticks : Wait_Ticks;
      Item  : out Word;
      Fresh : out Boolean);

   --  A mailbox from which this message was received, without a miss.
   procedure Begin_With (Old : Word);

   --  Expects this outcome of a RECV.
   procedure Expect_Receive
     (When_It_Was : String;
      Ticks       : Wait_Ticks;
      Data        : Word;
      Fresh       : Boolean);

   procedure Expect_Misses (When_It_Was : String; Expected : Count);

   procedure Send (Item : Word);

   --  The producer: the EXIT at which it sends, and its message.
   Send_At_Exit : Natural := 0;
   To_Send      : constant Word := 77;
   procedure Producer_Sends;
   procedure Clock_Runs_Back;

   procedure Receive_Within
     (Ticks : Wait_Ticks;
      Item  : out Word;
      Fresh : out Boolean)
   is
      Timeout    : Wait := Begun (Now, Ticks);
      Look_Again : Boolean;
   begin
      loop
         Looked := Looked + 1;
         Calls.Receive_Step (Now, Timeout, Item, Fresh, Look_Again);
         exit when not Look_Again;
         Exit_Processor;
      end loop;
   end Receive_Within;

   procedure Send (Item : Word) is
      Success : Boolean;
   begin
      Variable.Send (Item, Success);
      Expect ("sent into an empty box", Success, True);
   end Send;

   procedure Begin_With (Old : Word) is
      Item  : Word;
      Fresh : Boolean;
   begin
      Variable.Reset;
      Send (Old);
      Variable.Receive (Item, Fresh);
      Expect ("received to begin with", Item, Old);
      Expect ("fresh to begin with", Fresh, True);
      Looked := 0;
   end Begin_With;

   procedure Expect_Receive
     (When_It_Was : String;
      Ticks       : Wait_Ticks;
      Data        : Word;
      Fresh       : Boolean)
   is
      Item     : Word;
      Is_Fresh : Boolean;
   begin
      Receive_Within (Ticks, Item, Is_Fresh);
      Expect (When_It_Was & ", fresh", Is_Fresh, Fresh);
      Expect (When_It_Was & ", received", Item, Data);
   end Expect_Receive;

   procedure Expect_Misses (When_It_Was : String; Expected : Count) is
      Box : constant Messages.Boxes.Mailbox := Variable.Snapshot;
   begin
      Expect
        (When_It_Was & ", misses", Messages.Boxes.Misses (Box), Expected);
      Expect
        (When_It_Was & ", left fresh", Messages.Boxes.Is_Fresh (Box), False);
   end Expect_Misses;

   procedure Producer_Sends is
   begin
      if Exits = Send_At_Exit then
         Send (To_Send);
      end if;
   end Producer_Sends;

   procedure Clock_Runs_Back is
   begin
      if Exits mod 5 = 4 then
         Now := 90;
      end if;
   end Clock_Runs_Back;

   procedure Quiet_Looks is
      Item  : Word;
      Fresh : Boolean;
   begin
      Begin_With (5);
      for Times in 1 .. 10 loop
         Variable.Look (Item, Fresh);
         Expect ("a look in vain, fresh", Fresh, False);
         Expect ("a look in vain, message", Item, 5);
         Expect_Misses ("a look in vain", 0);
      end loop;
      Send (6);
      Variable.Look (Item, Fresh);
      Expect ("a look not in vain, fresh", Fresh, True);
      Expect ("a look not in vain, message", Item, 6);
      Expect_Misses ("a look not in vain", 0);
      Variable.Receive (Item, Fresh);
      Expect ("then a receive, fresh", Fresh, False);
      Expect ("then a receive, message", Item, 6);
      Expect_Misses ("then a receive", 1);
   end Quiet_Looks;

   procedure No_Wait is
   begin
      Begin_With (5);
      Begin_At (100, Exits_Per_Tick => 1);
      Expect_Receive ("nothing new", 0, 5, Fresh => False);
      Expect_Misses ("nothing new", 1);
      Send (6);
      Expect_Receive ("something new", 0, 6, Fresh => True);
      Expect_Misses ("something new", 1);
      Expect_Number ("EXITs", Exits, 0);
      Expect ("looks", Looked, 2);
   end No_Wait;

   procedure At_Once is
   begin
      Begin_With (5);
      Begin_At (100, Exits_Per_Tick => 1);
      Send (6);
      Expect_Receive ("something new", 10, 6, Fresh => True);
      Expect_Misses ("something new", 0);
      Expect_Number ("EXITs", Exits, 0);
      Expect ("looks", Looked, 1);
   end At_Once;

   procedure In_Vain is
   begin
      for Ticks in Wait_Ticks range 1 .. 20 loop
         for Per_Tick in 1 .. 4 loop
            Begin_With (5);
            Begin_At (100, Per_Tick);
            Expect_Receive ("nothing came", Ticks, 5, Fresh => False);
            Expect_Misses ("nothing came", 1);
            Expect ("it ended", Now, 100 + Tick (Ticks));
            Expect_Number ("EXITs", Exits, Per_Tick * Integer (Ticks));
            Expect ("looks", Looked, Count (Exits) + 1);
         end loop;
      end loop;
   end In_Vain;

   procedure At_Any_Exit is
   begin
      --  Twelve EXITs are three ticks. The last one ends the wait.
      for Which in 1 .. 12 loop
         Begin_With (5);
         Begin_At (100, 4, Producer_Sends'Access);
         Send_At_Exit := Which;
         Expect_Receive
           ("sent at EXIT" & Which'Image, 3, To_Send, Fresh => True);
         Expect_Misses ("sent at EXIT" & Which'Image, 0);
         Expect_Number ("EXITs", Exits, Which);
      end loop;

      Begin_With (5);
      Begin_At (100, 4, Producer_Sends'Access);
      Send_At_Exit := 13;
      Expect_Receive ("sent too late", 3, 5, Fresh => False);
      Expect_Misses ("sent too late", 1);
      Exit_Processor;
      Expect_Receive ("the next time", 3, To_Send, Fresh => True);
      Expect_Misses ("the next time", 1);
   end At_Any_Exit;

   procedure Many_Misses is
   begin
      Begin_With (5);
      Begin_At (0, Exits_Per_Tick => 3);
      for Times in Count range 1 .. 50 loop
         Expect_Receive ("in vain", 2, 5, Fresh => False);
         Expect_Misses ("in vain", Times);
         Expect ("looks", Looked, 7 * Times);
      end loop;
   end Many_Misses;

   procedure In_Steps is
      Timeout : Wait := Begun (100, 3);
      Item    : Word;
      Fresh   : Boolean;
      Again   : Boolean;
   begin
      --  In virtual time two steps are one tick apart.
      Begin_With (5);
      Begin_At (100, Exits_Per_Tick => 1);
      for Step in 1 .. 4 loop
         Calls.Receive_Step (Now, Timeout, Item, Fresh, Again);
         Expect ("fresh in step" & Step'Image, Fresh, False);
         Expect ("received in step" & Step'Image, Item, 5);
         Expect ("again after step" & Step'Image, Again, Step < 4);
         Expect_Misses ("step" & Step'Image, (if Step < 4 then 0 else 1));
         Exit_Processor;
      end loop;

      Timeout := Begun (Now, 3);
      Calls.Receive_Step (Now, Timeout, Item, Fresh, Again);
      Expect ("again after the first step", Again, True);
      Send (6);
      Calls.Receive_Step (Now, Timeout, Item, Fresh, Again);
      Expect ("fresh in the second", Fresh, True);
      Expect ("received in the second", Item, 6);
      Expect ("again after the second", Again, False);
   end In_Steps;

   procedure Stopped_Clock is
   begin
      Begin_With (5);
      Begin_At (100, Exits_Per_Tick => 0);
      Expect_Receive ("a stopped clock", 20, 5, Fresh => False);
      Expect_Misses ("a stopped clock", 1);
      Expect ("looks", Looked, 100_001);
      Expect_Receive ("and no wait", 0, 5, Fresh => False);
      Expect ("looks", Looked, 100_002);
   end Stopped_Clock;

   procedure End_Of_Time is
   begin
      Begin_With (5);
      Begin_At (Last_Tick, Exits_Per_Tick => 1);
      Expect_Receive ("at the last tick", 20, 5, Fresh => False);
      Expect ("looks at the last tick", Looked, 1);
      Expect_Misses ("at the last tick", 1);

      Begin_With (5);
      Begin_At (Last_Tick - 3, Exits_Per_Tick => 1);
      Expect_Receive ("near the last tick", 20, 5, Fresh => False);
      Expect ("looks near the last tick", Looked, 4);
      Expect_Misses ("near the last tick", 1);
   end End_Of_Time;

   procedure Back_In_Time is
   begin
      --  The clock shows 100 to 103, then 90 to 94 repeatedly. From the look
      --  at 103 on it counts as stopped.
      Begin_With (5);
      Begin_At (100, 1, Clock_Runs_Back'Access);
      Expect_Receive ("back in time", 20, 5, Fresh => False);
      Expect_Misses ("back in time", 1);
      Expect ("looks", Looked, 3 + 100_001);
   end Back_In_Time;

   procedure Any_Clock is
      Random  : Look_Count := 1;
      Timeout : Wait;
      Shown   : Clock_Tick;
      Latest  : Clock_Tick;
      Before  : Look_Count;
   begin
      for Ticks in Wait_Ticks range 0 .. 500 loop
         Shown   := 1_000;
         Latest  := Shown;
         Timeout := Begun (Shown, Ticks);
         Expect ("0 ticks are over", Is_Over (Timeout, Shown), Ticks = 0);
         while not Is_Over (Timeout, Shown) loop
            Before := Looks_Left (Timeout);
            Note_Look (Timeout, Shown);
            Expect ("fewer looks left", Looks_Left (Timeout) < Before, True);

            --  The clock mostly stops; now and then it runs back.
            Random := (Random * 171) mod 30_269;
            Shown  :=
              (case Random mod 8 is
                  when 0 .. 4 => Shown,
                  when 5      => Shown + 1,
                  when 6      => Shown + Tick (Random mod 4),
                  when others => Shown - 1);
            Latest := Tick'Max (Latest, Shown);
            Expect
              ("over when its ticks have passed", Is_Over (Timeout, Shown),
               Latest - 1_000 >= Tick (Ticks));
         end loop;
      end loop;
   end Any_Clock;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "MBX-3 a look consumes a fresh message and counts no miss",
         Quiet_Looks'Access);
      Add (Suite, "MBX-3 RECV with a wait of 0 looks once", No_Wait'Access);
      Add
        (Suite, "MBX-3 RECV of a fresh message does not wait",
         At_Once'Access);
      Add
        (Suite, "MBX-3 RECV in vain gives the old message after its ticks",
         In_Vain'Access);
      Add
        (Suite, "MBX-3 a message at any EXIT up to the last is in time",
         At_Any_Exit'Access);
      Add
        (Suite, "MBX-3 each RECV in vain is one miss, however often it looked",
         Many_Misses'Access);
      Add
        (Suite, "MBX-3 a task in steps looks in each of them",
         In_Steps'Access);
      Add
        (Suite, "MBX-5 RECV ends when the clock stops",
         Stopped_Clock'Access);
      Add
        (Suite, "MBX-5 at the clock's last tick RECV looks once",
         End_Of_Time'Access);
      Add
        (Suite, "MBX-5 RECV ends when the clock runs back",
         Back_In_Time'Access);
      Add
        (Suite, "MBX-5 500 waits by a wild clock end when they should",
         Any_Clock'Access);
   end Add_To;

end Receive_Calls_Tests;
