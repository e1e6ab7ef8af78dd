--  SPDX-License-Identifier: Apache-2.0

package body URV.Allocation with SPARK_Mode is

   function Help_Of (Helper : Surface; Missing : Deficits) return Help is
      Sum : Help := 0;
   begin
      for Failed in Surface loop
         Sum := Sum + Part_For (Failed, Helper, Missing (Failed));
         pragma Loop_Invariant
           (abs Sum <= 20_000 * (Surface'Pos (Failed) + 1));
      end loop;
      return Sum;
   end Help_Of;

   function Rolled_By_Flaps
     (Wanted : Surface_Demands; Now : Health) return Flap_Roll
   is
      Part : Number;
      Sum  : Flap_Roll := 0;
   begin
      for Item in Flap loop
         Part :=
           (if Now.Failed (Item) then 0
            else Roll_By (Item, Now.Places (Item) - Wanted (Item)));
         pragma Assert
           (if Rolls_Right (Item, Wanted, Now) then Part >= 0);
         pragma Assert (if Rolls_Left (Item, Wanted, Now) then Part <= 0);
         Sum := Sum + Part;
         pragma Loop_Invariant
           (abs Sum <= 2_500 * (Surface'Pos (Item)
                                - Surface'Pos (Flap'First) + 1));
         pragma Loop_Invariant
           ((if (for all Done in Flap'First .. Item =>
                   Rolls_Right (Done, Wanted, Now))
             then Sum >= 0)
            and then
              (if (for all Done in Flap'First .. Item =>
                     Rolls_Left (Done, Wanted, Now))
               then Sum <= 0));
      end loop;
      return Sum;
   end Rolled_By_Flaps;

   function Demands
     (Wanted : Surface_Demands; Now : Health) return Surface_Demands
   is
      Missing : constant Deficits := Missing_Of (Wanted, Now);
      Beyond  : Number := 0;
      Rolled  : Flap_Roll := 0;
      Goal    : Number;
      Result  : Surface_Demands := Wanted;
   begin
      if Now.Failed = None then
         return Result;
      end if;

      --  If one aileron has failed, the travel of the other may not suffice.
      if Now.Failed (Left_Aileron) /= Now.Failed (Right_Aileron) then
         Goal :=
           (if Now.Failed (Left_Aileron)
            then Wanted (Right_Aileron) + Help_Of (Right_Aileron, Missing)
            else Wanted (Left_Aileron) + Help_Of (Left_Aileron, Missing));
         Beyond := Beyond_Share (Goal);
         Rolled := Rolled_By_Flaps (Wanted, Now);
      end if;

      for Item in Surface loop
         if not Now.Failed (Item) then
            Goal := Wanted (Item) + Help_Of (Item, Missing)
              + (if Item in Flap then Flap_Part (Item, Beyond)
                 elsif Item in Left_Aileron | Right_Aileron then -Rolled
                 else 0);
            Result (Item) := Reachable (Item, Goal);
         end if;
         pragma Loop_Invariant
           (for all Done in Surface'First .. Item =>
              (if Now.Failed (Done) then Result (Done) = Wanted (Done)
               else Result (Done) in Lowest (Done) .. Highest (Done)));
         pragma Loop_Invariant
           (for all Later in Surface =>
              (if Later > Item then Result (Later) = Wanted (Later)));
      end loop;
      return Result;
   end Demands;

   procedure Make_Up (Result : in out PWM_Buffer; Now : Health)
   with
     Global => null,
     Pre    =>
       (for all Item in Servo_Item => Result (Item) in Converter_Value),
     Post   =>
       (for all Item in Servo_Item => Result (Item) in Converter_Value)
       and then Result (Steering) = Result'Old (Steering)
       and then Result (Throttle) = Result'Old (Throttle)
       and then Result (Brake) = Result'Old (Brake)
       and then Result (Discretes) = Result'Old (Discretes)
       and then
         (for all Item in Surface =>
            Demand_Of (Result (Servo_Of (Item))) =
              Demands (Demands_Of (Result'Old), Now) (Item));

   procedure Make_Up (Result : in out PWM_Buffer; Now : Health) is
      Given : constant Surface_Demands := Demands (Demands_Of (Result), Now);
   begin
      Result (Left_Aileron)   := Word_Of (Given (Left_Aileron));
      Result (Right_Aileron)  := Word_Of (Given (Right_Aileron));
      Result (Left_Elevator)  := Word_Of (Given (Left_Elevator));
      Result (Right_Elevator) := Word_Of (Given (Right_Elevator));
      Result (Left_Rudder)    := Word_Of (Given (Left_Rudder));
      Result (Right_Rudder)   := Word_Of (Given (Right_Rudder));
      Result (Left_Flap_1)    := Word_Of (Given (Left_Flap_1));
      Result (Right_Flap_1)   := Word_Of (Given (Right_Flap_1));
      Result (Left_Flap_2)    := Word_Of (Given (Left_Flap_2));
      Result (Right_Flap_2)   := Word_Of (Given (Right_Flap_2));
      pragma Assert
        (for all Item in Servo_Item => Result (Item) in Converter_Value);
      pragma Assert
        (for all Item in Surface =>
           Demand_Of (Result (Servo_Of (Item))) = Given (Item));
   end Make_Up;

   function Servos (Commands : Uplink_Buffer; Now : Health) return PWM_Buffer
   is
      Result : PWM_Buffer := Transform (Commands);
   begin
      if Now.Failed /= None then
         pragma Assert
           (for all Item in Servo_Item => Result (Item) in Converter_Value);
         Make_Up (Result, Now);
      end if;
      return Result;
   end Servos;

end URV.Allocation;
