--  SPDX-License-Identifier: Apache-2.0

--  A node that has nothing to do with aircraft: a thermostat. See README.md.

with URVOS;              use URVOS;
with URVOS.Error_Logs;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Node_Software;
with URVOS.Receive_Calls;
with URVOS.Semaphore_Calls;
with URVOS.Semaphores;   use URVOS.Semaphores;
with URVOS.Shared_Data;
with URVOS.Shared_Error_Logs;
with URVOS.Shared_Mailboxes;
with URVOS.Shared_Semaphores;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Lists;
with URVOS.Task_Trees;   use URVOS.Task_Trees;
with URVOS.Waits;        use URVOS.Waits;

package Thermostat with SPARK_Mode is

   --  Hundredths of a degree Celsius.
   subtype Temperature is Word range 0 .. 50_00;
   Wanted : constant Temperature := 20_00;

   --  The room, and the heater in it.
   package Temperatures is new URVOS.Shared_Data (Temperature, 18_00);
   package Flags is new URVOS.Shared_Data (Boolean, False);
   Room         : Temperatures.Store;
   Heater_Is_On : Flags.Store;

   --  The errors of the log.
   type Trouble is
     (Task_Overrun, Semaphore_Not_Claimed, Semaphore_Not_Owned);
   package Logs is new URVOS.Error_Logs (Trouble);
   package Shared_Logs is new URVOS.Shared_Error_Logs (Logs);
   Log : Shared_Logs.Shared_Log;

   --  Between the tasks: the reading, and who may switch the heater.
   package Readings is new URVOS.Shared_Mailboxes (Temperature, Wanted);
   Reading : Readings.Variable;
   Switch  : URVOS.Shared_Semaphores.Flag;

   procedure Report_Not_Claimed (Caller, Holder : Claimant);
   procedure Report_Not_Owned (Caller : Claimant; Holder : Task_Id);

   package Switch_Calls is new URVOS.Semaphore_Calls
     (Switch, Report_Not_Claimed, Report_Not_Owned);
   package Reading_Calls is new URVOS.Receive_Calls (Readings, Reading);

   --  The tasks, in order of priority.
   type Task_Name is (Sensor, Guest, Control);
   type Task_Table is array (Task_Name) of Task_Attributes;
   Task_List : constant Task_Table :=
     (Sensor  => (others => (Offset => 3, Processor => 1)),
      Guest   => (others => (Offset => 0, Processor => 1)),
      Control => (others => (Offset => 1, Processor => 2)));
   package Tasks is new URVOS.Task_Lists (Task_Name, Task_Table, Task_List);

   --  The state of the control between steps.
   type Place is (At_Rest, Receiving, Claiming);
   type Progress is record
      Doing   : Place       := At_Rest;
      Timeout : Wait        := Begun (0, 0);
      Newest  : Temperature := Wanted;
   end record;
   package Stores is new URVOS.Shared_Data (Progress, (others => <>));
   Control_State : Stores.Store;

   --  For the kernel.
   procedure Run_Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);
   procedure Begin_Again
     (Condition : Start_Condition; Now : Clock_Tick; Passed : out Boolean);
   procedure Set_Time (Now : Clock_Tick);
   procedure Report_Overrun (Who : Task_Id);

   package Software is new URVOS.Node_Software
     (Tasks, Run_Step, Begin_Again, Set_Time, Report_Overrun);

end Thermostat;
