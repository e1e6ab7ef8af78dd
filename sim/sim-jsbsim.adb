--  SPDX-License-Identifier: Apache-2.0

with Sim.JSBSim.Process;

package body Sim.JSBSim is

   --  An answer received before it was requested.
   Early     : State_Message;
   Has_Early : Boolean := False;

   procedure Receive_State
     (Errors  : Sensor_Values;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State);

   procedure Receive_State
     (Errors  : Sensor_Values;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State) is
   begin
      if not Has_Early then
         Process.Receive (Early);
      end if;
      Has_Early := False;
      Read (Early, Sensors, Truth, Shown, Errors);
   end Receive_State;

   procedure Start
     (Shown_After : Step_Count;
      Further     : String;
      Schedule    : Schedule_Name;
      Errors      : Sensor_Values;
      Sensors     : out Sensor_Words;
      Truth       : out Flight_State;
      Shown       : out Shown_State) is
   begin
      Stop;
      Has_Early := False;
      Process.Spawn;
      Process.Send (Introduction (Shown_After, Further, Schedule));
      declare
         Answer : constant String := Process.Received_Line;
      begin
         if Answer /= Ready then
            Process.Refuse_Flight (Answer);
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
      --  Sleeping at once leaves the processor to the other process.
      if Process.Is_Alone then
         Process.Receive (Early);
         Has_Early := True;
      end if;
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
