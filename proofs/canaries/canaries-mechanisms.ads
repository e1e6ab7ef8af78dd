--  SPDX-License-Identifier: Apache-2.0

--  Mechanisms of the flight software with one sign, sensor or step wrong
--  (EXT-3, EXT-5, EXT-6, SAF-7, INI-3, KRN-3). Each claim is a postcondition
--  of the true mechanism, and is proved of it.

with URV.Allocation;      use URV.Allocation;
with URV.Buffers;         use URV.Buffers;
with URV.CORE_Memory;     use URV.CORE_Memory;
with URV.Errors;          use URV.Errors, URV.Errors.Logs;
with URV.Integrators;     use URV.Integrators;
with URV.Law_Axes;        use URV.Law_Axes;
with URV.Law_Gains;       use URV.Law_Gains;
with URV.Law_Units;       use URV.Law_Units;
with URV.Laws;            use URV.Laws;
with URV.Link_Loss;       use URV.Link_Loss;
with URV.Sensor_Checks;   use URV.Sensor_Checks;
with URV.Surface_Monitor; use URV.Surface_Monitor;
with URV.Surfaces;        use URV.Surfaces;
with URVOS.Frames;        use URVOS.Frames;
with URVOS.Schedulers;    use URVOS.Schedulers;
with URVOS.Starts;        use URVOS.Starts;

package Canaries.Mechanisms with SPARK_Mode, Ghost is

   --  Integrators that move away from their demands.

   procedure Ailerons_Go_The_Other_Way
     (Trim      : Roll_Trim;
      Reference : Bank_Command;
      Now       : Readings;
      Output    : Saturation;
      By        : Gain)
   with
     Global => null,
     Post   =>
       Moves_With
         (Trim,
          Next_Roll_Trim (Trim, Bank_Error (Reference, Now), Output, By),
          Wanted => Reference, Measured => Now.Bank)
       and then
         Moves_With  --  VC_POSTCONDITION
           (Trim,
            Next_Roll_Trim (Trim, -Bank_Error (Reference, Now), Output, By),
            Wanted => Reference, Measured => Now.Bank);

   procedure Elevators_Go_The_Other_Way
     (Trim      : Pitch_Trim;
      Reference : Pitch_Command;
      Now       : Readings;
      Output    : Saturation;
      By        : Gain)
   with
     Global => null,
     Post   =>
       Moves_With
         (Trim,
          Next_Pitch_Trim (Trim, Pitch_Error (Reference, Now), Output, By),
          Wanted => Reference, Measured => Now.Pitch)
       and then
         Moves_With  --  VC_POSTCONDITION
           (Trim,
            Next_Pitch_Trim (Trim, -Pitch_Error (Reference, Now), Output, By),
            Wanted => Reference, Measured => Now.Pitch);

   procedure The_Lever_Goes_The_Other_Way
     (Trim : Power_Trim; Wanted, Airspeed : Level; Output : Saturation)
   with
     Global => null,
     Post   =>
       Moves_With
         (Trim, Next_Power_Trim (Trim, Wanted - Airspeed, Output),
          Wanted => Wanted, Measured => Airspeed)
       and then
         Moves_With  --  VC_POSTCONDITION
           (Trim, Next_Power_Trim (Trim, Airspeed - Wanted, Output),
            Wanted => Wanted, Measured => Airspeed);

   --  The pitch law reads the bank sensor.
   procedure Pitch_Is_Of_The_Bank
     (Before   : URV.Laws.Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      After    : out URV.Laws.Memory)
   with
     Global => null,
     Post   =>
       (if Before.Flown.Vertical in Pitched
          and then After.Flown.Vertical in Pitched
        then Moves_With  --  VC_POSTCONDITION
          (Before.Pitch_Trim, After.Pitch_Trim,
           Wanted   => After.Pitch_Wanted,
           Measured =>
             Pitch_Angle_Of (Word_Of (After.Checks, Roll_Attitude))));

   --  Silent frames cost a link that returns nothing.
   procedure Gaps_Cost_Nothing (Before : Link_Memory; By : Times)
   with
     Global => null,
     Pre    => Before.State in Holding | Orbiting,
     Post   =>
       Next (Before, False, False, By).Fresh =
         Less_Of_Return (Before.Fresh)
       and then
         Next (Before, False, False, By).Fresh =  --  VC_POSTCONDITION
           Before.Fresh;

   --  The flaps roll to the side of the lowered flap.
   procedure Flaps_Roll_To_Their_Own_Side
     (Wanted : Surface_Demands; Now : Health)
   with
     Global => null,
     Pre    => (for all Item in Flap => Rolls_Right (Item, Wanted, Now)),
     Post   =>
       Rolled_By_Flaps (Wanted, Now) >= 0
       and then -Rolled_By_Flaps (Wanted, Now) >= 0;  --  VC_POSTCONDITION

   --  A measured position is not kept.
   procedure The_Place_Is_That_Of_Before
     (Before  : Monitor;
      Sensors : Downlink_Buffer;
      Which   : Surface;
      After   : out Monitor)
   with
     Global => null,
     Pre    => not Is_Old (Sensors),
     Post   =>
       After.Places (Which) = Places_Of (Sensors) (Which)
       and then
         After.Places (Which) =  --  VC_POSTCONDITION
           Before.Places (Which);

   --  A clock tick wakes the tasks by the old time.
   procedure Wake_At_The_Old_Time (S : in out Scheduler; Now : Clock_Tick)
   with
     Global => null,
     Pre    => Now >= Clock (S),
     Post   => Clock (S) = Now;  --  VC_POSTCONDITION

   --  A cold start leaves the log as it was.
   procedure The_Log_Is_Kept (Log : URV.Errors.Error_Log; Kind : Error_Kind)
   with
     Global => null,
     Post   =>
       History_Of
         (After_Start (Log, Warm_Reset, True), Kind) =
           History_Of (Log, Kind)
       and then
         History_Of  --  VC_POSTCONDITION
           (After_Start (Log, Cold_Start, True), Kind) =
             History_Of (Log, Kind);

   --  A warm start marks no word of the logs and of the uplink.
   procedure A_Start_Marks_No_Log
     (CORE : URV.CORE_Memory.Memory; Which : Log_Row_Number)
   with
     Global => null,
     Post   =>
       Marked_Old (CORE).Log (Which) = CORE.Log (Which)
       and then
         Marked_Old (CORE).Uplink =  --  VC_POSTCONDITION
           CORE.Uplink;

end Canaries.Mechanisms;
