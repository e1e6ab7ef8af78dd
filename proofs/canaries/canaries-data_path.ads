--  SPDX-License-Identifier: Apache-2.0

--  Claims about words on their way that are false of a few of them.

with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URV.Buffers;       use URV.Buffers;
with URV.Codecs;
with URV.PWM_Transform; use URV.PWM_Transform;

package Canaries.Data_Path with Pure, SPARK_Mode, Ghost is

   use URV.Codecs.Uplink;

   --  Not the words that exceed 12 bits.
   procedure Roll_Reaches_The_Aileron (Commands : Uplink_Buffer)
   with
     Global => null,
     Post   =>
       Transform (Commands) (Left_Aileron) =  --  VC_POSTCONDITION
         Commands (Roll);

   --  The low byte comes second.
   procedure Low_Byte_Comes_First (High, Low : Byte)
   with
     Global => null,
     Post   =>
       Low_Byte (To_Word (High, Low)) = High;  --  VC_POSTCONDITION

   --  At its last tick the clock stands still.
   procedure Clock_Runs (Now : Clock_Tick)
   with
     Global => null,
     Post   => Advanced (Now) > Now;  --  VC_POSTCONDITION

end Canaries.Data_Path;
