--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Safety with SPARK_Mode is

   procedure Neutral_Words_Are_Safe is null;

   procedure The_Servos_Never_Move
     (Ground   : in out Ground_Way;
      Line     : in out Line_Way;
      Aircraft : in out Aircraft_Way;
      Scans    : Scan_History;
      Now      : Event)
   is
   begin
      Happen (Ground, Line, Aircraft, Scans, Now);
   end The_Servos_Never_Move;

   procedure The_Servos_Have_The_Last_Scan
     (Item  : Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count)
   is null;

   procedure Switches_Are_Off
     (Item  : Aircraft_Way;
      Scans : Scan_History;
      Done  : Scan_Count)
   is null;

   procedure Any_Last_Piece_Makes_A_Row
     (Item  : in out Receiver;
      Which : Log_Row_Number;
      Row   : Log_Row;
      Whole : out Boolean)
   is
   begin
      Take (Item, Piece_At (Which, Row, Place'Last), Whole);
   end Any_Last_Piece_Makes_A_Row;

end Canaries.Safety;
