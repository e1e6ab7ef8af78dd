--  SPDX-License-Identifier: Apache-2.0

package body Simulated_Line is

   Present         : Event_Plan := (others => 0);
   Access_Count    : Natural    := Planned_Accesses;
   Character_Count : Natural    := 0;

   procedure Begin_Plan (Plan : Event_Plan) is
   begin
      Present := Plan;
      Access_Count := 0;
      Character_Count := 0;
   end Begin_Plan;

   procedure Begin_Access (Events : out Event_Count) is
   begin
      Events := 0;
      if not Is_Over then
         Access_Count := Access_Count + 1;
         Events := Present (Access_Count);
      end if;
   end Begin_Access;

   function Is_Over return Boolean is (Access_Count = Planned_Accesses);

   procedure Arrive (Item : out Sent_Character) is
   begin
      Item := Sent (Character_Count);
      Character_Count := Character_Count + 1;
   end Arrive;

   function Arrived return Natural is (Character_Count);

end Simulated_Line;
