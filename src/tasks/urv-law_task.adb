--  SPDX-License-Identifier: Apache-2.0

with URVOS;        use URVOS;
with URV.Buffers;  use URV.Buffers;
with URV.Errors;   use URV.Errors;
with URV.Laws;     use URV.Laws;
with URV.Link_Loss; use URV.Link_Loss;
with URV.Routing;

package body URV.LAW_Task with SPARK_Mode is

   --  What has changed is worth a line in the log.
   procedure Report (Before, After : Memory)
   with Global => (In_Out => Errors);

   procedure Report (Before, After : Memory) is
   begin
      if After.Link.State /= Before.Link.State
        and then Before.Link.State /= Waiting
      then
         Errors.Report
           (Link_Loss_State, Word (Link_State'Pos (After.Link.State)));
      end if;

      for Sensor in Sensor_Item loop
         if Before.Checks (Sensor).Is_Valid
           and then not After.Checks (Sensor).Is_Valid
         then
            Errors.Report
              (Sensor_Not_Valid, Word (Sensor_Item'Pos (Sensor) + 1));
         end if;
      end loop;
   end Report;

   procedure Run_Transaction is
      Set      : constant Settings := Law_Settings.Contents;
      Before   : constant Memory   := Law_Memory.Contents;
      After    : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      Fresh    : Boolean;
      Success  : Boolean;
   begin
      Sensors_Variable.Receive (Sensors, Fresh);
      if not Fresh then
         Sensors := Routing.As_Old (Sensors);
      end if;

      Commands_Variable.Receive (Commands, Fresh);
      if Set.On then
         if not Fresh then
            Commands := Routing.As_Old (Commands);
         end if;
         After := Next (Before, Commands, Sensors, Set.By);
         Report (Before, After);
         Law_Memory.Write (After);
         Commands := Output (After, Commands);
      end if;

      if Set.On or else Fresh then
         PWM_Variable.Send (Commands, Success);
         if not Success then
            Errors.Report (Commands_Not_Consumed, 0);
         end if;
      end if;
   end Run_Transaction;

end URV.LAW_Task;
