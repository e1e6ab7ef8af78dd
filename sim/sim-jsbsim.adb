--  SPDX-License-Identifier: Apache-2.0

with Sim.JSBSim.Process;

package body Sim.JSBSim is

   procedure Receive_State
     (Errors  : Sensor_Values;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State);

   procedure Receive_State
     (Errors  : Sensor_Values;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State)
   is
      Message : State_Message;
   begin
      Process.Receive (Message);
      Read (Message, Sensors, Truth, Shown, Errors);
   end Receive_State;

   procedure Start
     (Shown_After : Step_Count;
      Further     : String;
      Errors      : Sensor_Values;
      Sensors     : out Sensor_Words;
      Truth       : out Flight_State;
      Shown       : out Shown_State) is
   begin
      Stop;
      Process.Spawn;
      Process.Send (Introduction (Shown_After, Further));
      declare
         Answer : constant String := Process.Received_Line;
      begin
         if Answer /= Ready then
            Process.Give_Up (Answer);
         end if;
      end;
      Receive_State (Errors, Sensors, Truth, Shown);
   exception
      when Plant_Failure =>
         Process.Give_Up ("plant.py has failed");
   end Start;

   procedure Begin_Step (Servos : PWM_Buffer) is
   begin
      Process.Send (To_Message (Servos));
   end Begin_Step;

   procedure End_Step
     (Errors  : Sensor_Values;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State) is
   begin
      Receive_State (Errors, Sensors, Truth, Shown);
   end End_Step;

   procedure Stop is
   begin
      Process.Stop;
   end Stop;

end Sim.JSBSim;
