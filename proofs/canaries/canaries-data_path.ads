--  SPDX-License-Identifier: Apache-2.0

--  Claims about words on their path that are false for a few words.

with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URV.Buffers;       use URV.Buffers;
with URV.Codecs;
with URV.PWM_Transform; use URV.PWM_Transform;

package Canaries.Data_Path with Pure, SPARK_Mode, Ghost is

   use URV.Codecs.Uplink;

   --  False for words beyond 12 bits.
   procedure Roll_Reaches_The_Aileron (Commands : Uplink_Buffer)
   with
     Global => null,
     Post   =>
       Transform (Commands) (Left_Aileron) =  --  VC_POSTCONDITION
         Commands (Roll);

   --  False: the low byte comes second.
   procedure Low_Byte_Comes_First (High, Low : Byte)
   with
     Global => null,
     Post   =>
       Low_Byte (To_Word (High, Low)) = High;  --  VC_POSTCONDITION

   --  False for the last tick, at which the clock stops.
   procedure Clock_Runs (Now : Clock_Tick)
   with
     Global => null,
     Post   => Advanced (Now) > Now;  --  VC_POSTCONDITION

end Canaries.Data_Path;
