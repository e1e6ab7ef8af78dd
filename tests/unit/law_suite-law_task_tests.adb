--  SPDX-License-Identifier: Apache-2.0

with Checks;       use Checks;
with Expectations; use Expectations;
with Law_Rig;      use Law_Rig;
with MCS;
with Task_Rig;     use Task_Rig;
with URVOS;        use URVOS;
with URV.Buffers;  use URV.Buffers;
with URV.Errors;   use URV.Errors;
with URV.Laws;     use URV.Laws;

separate (Law_Suite)
package body LAW_Task_Tests is

   --  The tests, in order.
   procedure Sensor_Told_Once;
   procedure Not_Consumed;

   type Command_List is array (Positive range <>) of Uplink_Buffer;

   procedure Clear;

   procedure Clear is
   begin
      MCS.Reset_Variables;
      MCS.Law_Settings.Write (Laws_Off);
      MCS.Errors.Clear;
   end Clear;

   procedure Sensor_Told_Once is
   begin
      for Which in Sensor_Item loop
         Clear;
         Fly (100);
         Expect_Errors ("all is well", MCS.Errors, None);
         Fly (2, (Level with delta Which => Word'Last));
         Expect_Errors (Which'Image & ", two bad", MCS.Errors, None);
         Fly (1, (Level with delta Which => Word'Last));
         Expect_Errors
           (Which'Image & ", three", MCS.Errors, (1 => Sensor_Not_Valid),
            Detail => Word (Sensor_Item'Pos (Which) + 1));
         Fly (5, (Level with delta Which => Word'Last));
         Expect
           (Which'Image & ", more of them",
            Logs.History_Of (MCS.Errors.Contents, Sensor_Not_Valid)
              .Occurrences = 0,
            True);
      end loop;
   end Sensor_Told_Once;

   procedure Not_Consumed is
      Newer   : constant Uplink_Buffer :=
        (Neutral_Uplink with delta Throttle => 1_234);
      Success : Boolean;
      Item    : Uplink_Buffer;
      Fresh   : Boolean;
   begin
      Clear;
      for Commands of Command_List'(Neutral_Uplink, Newer) loop
         Expect_Errors ("so far", MCS.Errors, None);
         MCS.Commands_Variable.Send (Commands, Success);
         MCS.LAW.Run_Transaction;
      end loop;
      Expect_Errors
        ("nobody took the first", MCS.Errors, (1 => Commands_Not_Consumed));
      MCS.PWM_Variable.Receive (Item, Fresh);
      Expect ("the newer stands", Item (Throttle), 1_234);
   end Not_Consumed;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "EXT-3 an invalid sensor is reported once, by number",
         Sensor_Told_Once'Access);
      Add
        (Suite, "MBX-2 commands that PWM does not take are reported",
         Not_Consumed'Access);
   end Add_To;

end LAW_Task_Tests;
