--  SPDX-License-Identifier: Apache-2.0

with Checks;                   use Checks;
with Expectations;             use Expectations;
with URVOS;                    use URVOS;
with URVOS.Frame_Clocks;       use URVOS.Frame_Clocks;
with URVOS.Frame_Locks;        use URVOS.Frame_Locks;
with URVOS.Frames;             use URVOS.Frames;
with URVOS.Shared_Frame_Locks;
with URVOS.Usual_Frames;

separate (Kernel_Suite)
package body Frame_Locks_Tests is

   --  The tests, in order.
   procedure Lengths;
   procedure Last_Ticks;
   procedure Directions;
   procedure Patient;
   procedure Switched_Off;
   procedure No_Lock;

   procedure Lengths is
      Start : constant Clock_Tick := 70;
      Clock : Frame_Clock;
   begin
      for Length in Frame_Length loop
         for Frame in Clock_Tick range 6 .. 8 loop
            --  Only a request for this frame counts.
            Clock := (Start, False);
            for Ticks in Tick range 1 .. 8 loop
               Clock := Ticked (Clock, (Frame * 10, Length));
               Expect ("in the frame", Clock.Now, Start + Ticks);
            end loop;
            for Ticks in 9 .. (if Frame = 7 then Length else 10) - 1 loop
               Clock := Ticked (Clock, (Frame * 10, Length));
               Expect ("its last minor frame", Clock.Now, Start + 9);
               Expect ("held", Clock.Held, Ticks = 10);
            end loop;
            Clock := Ticked (Clock, (Frame * 10, Length));
            Expect ("the next frame", Clock.Now, Start + 10);
            Expect ("not held", Clock.Held, False);
         end loop;
      end loop;
   end Lengths;

   procedure Last_Ticks is
      Frame : constant Clock_Tick := Last_Tick - 9;
   begin
      for Length in Frame_Length loop
         for Now in Frame + 8 .. Last_Tick loop
            Expect
              ("stands still",
               Ticked ((Now, True), (Frame, Length)).Now, Last_Tick);
         end loop;
      end loop;
   end Last_Ticks;

   --  Takes a message that has waited this number of ticks, in that frame.
   procedure Take
     (Item  : in out Lock_State;
      Ticks : Natural;
      Frame : Clock_Tick;
      Fresh : Boolean := True);

   procedure Take
     (Item  : in out Lock_State;
      Ticks : Natural;
      Frame : Clock_Tick;
      Fresh : Boolean := True) is
   begin
      Item := Ticked (Item, False);
      for Number in 0 .. Ticks loop
         Item := Ticked (Item, True);
      end loop;
      Item := Taken (Item, Fresh, Frame);
   end Take;

   procedure Expect_Request
     (What   : String;
      Item   : Lock_State;
      Frame  : Clock_Tick;
      Length : Integer);

   procedure Expect_Request
     (What   : String;
      Item   : Lock_State;
      Frame  : Clock_Tick;
      Length : Integer) is
   begin
      Expect (What & ", frame", Item.Request.Frame, Frame);
      Expect_Number (What & ", length", Integer (Item.Request.Length), Length);
   end Expect_Request;

   procedure Directions is
      Item : Lock_State;
   begin
      for Ticks in 0 .. 30 loop
         Item := At_Start;
         for Frame in Clock_Tick range 1 .. 3 loop
            Take (Item, Ticks, 10 * Frame);
            Expect_Request ("not yet", Item, 10 * Frame, 10);
         end loop;
         Take (Item, Ticks, 40);
         Expect_Request
           ("waited" & Ticks'Image, Item, 40,
            (case Ticks is when 1 => 10, when 2 .. 5 => 9, when others => 11));
         Expect ("in step", Item.Is_In_Step, Ticks = 1);
         if Ticks = 1 then
            Expect ("since", Item.Since, 10);
         end if;
         Expect
           ("shorter", Item.Shortened, (if Ticks in 2 .. 5 then 1 else 0));
         Expect
           ("longer", Item.Lengthened, (if Ticks in 1 .. 5 then 0 else 1));
         Take (Item, Ticks, 50);
         Expect_Request ("counts from zero", Item, 50, 10);
      end loop;
   end Directions;

   procedure Patient is
      Item : Lock_State;
   begin
      --  A message on time clears the count of those before.
      for Round in 1 .. 3 loop
         for Number in 1 .. 3 loop
            Take (Item, 0, 10);
         end loop;
         Take (Item, 1, 20);
         Expect_Request ("forgiven", Item, 20, 10);
      end loop;
      Expect ("in step", Item.Is_In_Step, True);

      --  A frame without a fresh message changes nothing; nor do old messages.
      for Number in Clock_Tick range 1 .. 3 loop
         Take (Item, 0, 10);
         for Lost in 1 .. 20 loop
            Take (Item, 4, 20, Fresh => False);
            Expect_Request ("nothing told", Item, 20, 10);
            Item := Taken (Item, False, 30);
            Expect_Request ("nothing came", Item, 30, 10);
         end loop;
      end loop;
      Expect ("still in step", Item.Is_In_Step, True);
      Take (Item, 0, 40);
      Expect_Request ("the fourth", Item, 40, 11);

      --  A start clears all but the request.
      Take (Item, 3, 50);
      Item := Restarted (Item);
      Expect_Request ("of before", Item, 50, 10);
      Expect ("who knows", Item.Is_In_Step, False);
      for Number in 1 .. 3 loop
         Take (Item, 3, 60);
         Expect_Request ("counts from none", Item, 60, 10);
      end loop;
   end Patient;

   procedure Switched_Off is
      Lock : URVOS.Shared_Frame_Locks.Lock;
   begin
      for Is_On in Boolean loop
         Lock.Set (Is_On);
         for Number in 1 .. 4 loop
            for Ticks in 1 .. 10 loop
               Lock.Tick (Available => Ticks > 5);
            end loop;
            Lock.Take (Fresh => True, Now => 123);
         end loop;
         Expect_Number
           ("length", Integer (Length_Of (125, Lock.Request)),
            (if Is_On then 9 else 10));
         Expect_Number ("of the next", Integer (Length_Of (130, Lock.Request)),
                        10);
         Lock.Restart;
         Expect_Number
           ("after a start", Integer (Length_Of (125, Lock.Request)),
            (if Is_On then 9 else 10));
      end loop;
   end Switched_Off;

   procedure No_Lock is
      Request : Frame_Request;
   begin
      for Ticks in Tick_Count loop
         URVOS.Usual_Frames (Ticks, Request);
         Expect
           ("frames as usual after" & Ticks'Image & " ticks",
            Request = No_Request, True);
      end loop;
   end No_Lock;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "FRM-6 a frame lasts 9, 10 or 11 ticks, as was wished for it",
         Lengths'Access);
      Add
        (Suite, "FRM-6 FRM-1 the clock stops at its last tick",
         Last_Ticks'Access);
      Add
        (Suite, "FRM-6 frames go the shorter way round",
         Directions'Access);
      Add
        (Suite, "FRM-6 four messages after each other change a frame",
         Patient'Access);
      Add
        (Suite, "FRM-6 only a lock that is on wishes anything",
         Switched_Off'Access);
      Add
        (Suite, "FRM-6 a node without a lock wishes for no other frame",
         No_Lock'Access);
   end Add_To;

end Frame_Locks_Tests;
