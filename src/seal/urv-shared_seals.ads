--  SPDX-License-Identifier: Apache-2.0

--  A node's seal, shared by TELIN, TELOUT and the node's start (SEC-1). By its
--  priority a bare machine masks no interrupts while a block is sealed.

with System;
with Telemetry;        use Telemetry;
with URVOS.Frames;     use URVOS.Frames;
with URV.Handshakes;   use URV.Handshakes;
with URV.Plain_Blocks; use URV.Plain_Blocks;
with URV.Seal_Blocks;  use URV.Seal_Blocks;
with URV.Sessions;     use URV.Sessions;

package URV.Shared_Seals with SPARK_Mode is

   --  Whole frames between two times; 1 if the clock was set back. The usual
   --  difference, one frame, needs no division.
   function Frames_Between (Before, Now : Clock_Tick) return Counter is
     (if Now < Before or else Now - Before = Ticks_Per_Major_Frame then 1
      else Counter
        (Tick'Min
           (Now / Ticks_Per_Major_Frame - Before / Ticks_Per_Major_Frame,
            Tick (Last_Age))))
   with
     Global => null,
     Post   =>
       (if Now >= Before
        then Tick (Frames_Between'Result) = Tick'Min
          (Now / Ticks_Per_Major_Frame - Before / Ticks_Per_Major_Frame,
           Tick (Last_Age)));

   protected type Shared_Seal (Role : Station)
     with Priority => System.Priority'Last
   is

      --  Call it before the node is switched on. Without it the format is 1.
      procedure Configure
        (Format : Format_Number;
         Keys   : Key_List;
         Start  : Nonce);

      --  Called at a cold start.
      procedure Restart;

      --  Sets the node's time: before each Open, and before each Close in a
      --  frame without an Open.
      procedure Set_Time (Now : Clock_Tick);

      procedure Open
        (Block   : Block_Data;
         Arrived : Boolean;
         Words   : out Block_Words;
         Result  : out Outcome);

      procedure Close (Data : Block_Words; Block : out Block_Data);

   private
      Item : Seal := New_Seal
        (Role, 1, [others => (others => <>)], 0);
      Seen : Clock_Tick := 0;
   end Shared_Seal;

end URV.Shared_Seals;
