package body URVOS.Executives
  with
    SPARK_Mode,
    Refined_State => (Sleepers => (Wake_Ups, Late_Releases))
is

   type Tick_Table is array (Task_Name) of Tick;

   Wake_Ups      : Tick_Table := (others => 0);
   Late_Releases : Count      := 0;

   procedure Start (Now : Clock_Tick)
   with
     Refined_Global => (Output => (Wake_Ups, Late_Releases))
   is
   begin
      Late_Releases := 0;
      Wake_Ups := (others => Next_Frame (Now));
      for Who in Task_Name loop
         Wake_Ups (Who) := Next_Release (Now, Offsets (Who));
         pragma Loop_Invariant
           (for all Earlier in Task_Name'First .. Who =>
              Wake_Ups (Earlier) = Next_Release (Now, Offsets (Earlier)));
      end loop;
   end Start;

   procedure Run_Due_Tasks (Now : Clock_Tick) is
   begin
      for Who in Task_Name loop
         if Wake_Ups (Who) <= Now then
            if Wake_Ups (Who) < Now then
               Late_Releases := Incremented (Late_Releases);
            end if;
            Run_Transaction (Who);
            Wake_Ups (Who) := Next_Release (Now, Offsets (Who));
         end if;
      end loop;
   end Run_Due_Tasks;

   function Wake_Up (Who : Task_Name) return Tick is (Wake_Ups (Who))
   with Refined_Global => Wake_Ups;

   function Overruns return Count is (Late_Releases)
   with Refined_Global => Late_Releases;

end URVOS.Executives;
