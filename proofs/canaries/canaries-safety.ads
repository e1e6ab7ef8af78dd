--  SPDX-License-Identifier: Apache-2.0

--  Claims about safety that are false for a few histories (SAF-1 to SAF-7).

with Devices.PWM_Board; use Devices.PWM_Board;
with Theorems.Safety;   use Theorems.Safety;
with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Log_Pieces;    use URV.Log_Pieces;
with URV.PWM_Layout;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Routing;       use URV.Routing;

package Canaries.Safety with SPARK_Mode, Ghost is

   --  False: the report's neutral word in the switches' channels turns all
   --  switches on. Early versions sent this word to the servos.
   procedure Neutral_Words_Are_Safe
   with
     Global => null,
     Post   =>
       Safe_Outputs =  --  VC_POSTCONDITION
         Transform
           (To_Uplink (Stamped (Neutral_Sensor_Words, Fresh => False)));

   --  False for commands that are not marked as old.
   procedure The_Servos_Never_Move
     (Ground   : in out Ground_Way;
      Line     : in out Line_Way;
      Aircraft : in out Aircraft_Way;
      Scans    : Scan_History;
      Now      : Event)
   with
     Global => null,
     Pre    =>
       Is_Sound (Ground, Scans)
       and then Is_Sound (Line, Scans, Ground.Done)
       and then Is_Sound (Aircraft, Scans, Ground.Done)
       and then Now.Kind = PWM_Runs,
     Post   =>
       Aircraft.Board = Aircraft'Old.Board;  --  VC_POSTCONDITION

   --  False: the servos need not have the scan that was completed last.
   procedure The_Servos_Have_The_Last_Scan
     (Item  : Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       Item.Board =  --  VC_POSTCONDITION
         URV.PWM_Layout.To_Data_Area (Outputs_Of (Scans, Done));

   --  False if an earlier scan turned the switch on.
   procedure Switches_Are_Off
     (Item  : Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count)
   with
     Global => null,
     Pre    => Is_Sound (Item, Scans, Done),
     Post   =>
       0 =  --  VC_POSTCONDITION
         Item.Board (URV.PWM_Layout.Channel_Of (Discretes));

   --  False if the row's first fragment was missed.
   procedure Any_Last_Piece_Makes_A_Row
     (Item  : in out Receiver;
      Which : Log_Row_Number;
      Row   : Log_Row;
      Whole : out Boolean)
   with
     Global => null,
     Post   => Whole;  --  VC_POSTCONDITION

end Canaries.Safety;
