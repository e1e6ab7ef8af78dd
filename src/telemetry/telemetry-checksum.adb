--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Checksum with SPARK_Mode is

   --  Times_X8 of each byte. A processor without a barrel shifter takes a
   --  fifth of the time.
   Products : constant array (Byte) of Byte :=
     (16#00#, 16#72#, 16#E4#, 16#96#, 16#F1#, 16#83#, 16#15#, 16#67#,
      16#DB#, 16#A9#, 16#3F#, 16#4D#, 16#2A#, 16#58#, 16#CE#, 16#BC#,
      16#8F#, 16#FD#, 16#6B#, 16#19#, 16#7E#, 16#0C#, 16#9A#, 16#E8#,
      16#54#, 16#26#, 16#B0#, 16#C2#, 16#A5#, 16#D7#, 16#41#, 16#33#,
      16#27#, 16#55#, 16#C3#, 16#B1#, 16#D6#, 16#A4#, 16#32#, 16#40#,
      16#FC#, 16#8E#, 16#18#, 16#6A#, 16#0D#, 16#7F#, 16#E9#, 16#9B#,
      16#A8#, 16#DA#, 16#4C#, 16#3E#, 16#59#, 16#2B#, 16#BD#, 16#CF#,
      16#73#, 16#01#, 16#97#, 16#E5#, 16#82#, 16#F0#, 16#66#, 16#14#,
      16#4E#, 16#3C#, 16#AA#, 16#D8#, 16#BF#, 16#CD#, 16#5B#, 16#29#,
      16#95#, 16#E7#, 16#71#, 16#03#, 16#64#, 16#16#, 16#80#, 16#F2#,
      16#C1#, 16#B3#, 16#25#, 16#57#, 16#30#, 16#42#, 16#D4#, 16#A6#,
      16#1A#, 16#68#, 16#FE#, 16#8C#, 16#EB#, 16#99#, 16#0F#, 16#7D#,
      16#69#, 16#1B#, 16#8D#, 16#FF#, 16#98#, 16#EA#, 16#7C#, 16#0E#,
      16#B2#, 16#C0#, 16#56#, 16#24#, 16#43#, 16#31#, 16#A7#, 16#D5#,
      16#E6#, 16#94#, 16#02#, 16#70#, 16#17#, 16#65#, 16#F3#, 16#81#,
      16#3D#, 16#4F#, 16#D9#, 16#AB#, 16#CC#, 16#BE#, 16#28#, 16#5A#,
      16#9C#, 16#EE#, 16#78#, 16#0A#, 16#6D#, 16#1F#, 16#89#, 16#FB#,
      16#47#, 16#35#, 16#A3#, 16#D1#, 16#B6#, 16#C4#, 16#52#, 16#20#,
      16#13#, 16#61#, 16#F7#, 16#85#, 16#E2#, 16#90#, 16#06#, 16#74#,
      16#C8#, 16#BA#, 16#2C#, 16#5E#, 16#39#, 16#4B#, 16#DD#, 16#AF#,
      16#BB#, 16#C9#, 16#5F#, 16#2D#, 16#4A#, 16#38#, 16#AE#, 16#DC#,
      16#60#, 16#12#, 16#84#, 16#F6#, 16#91#, 16#E3#, 16#75#, 16#07#,
      16#34#, 16#46#, 16#D0#, 16#A2#, 16#C5#, 16#B7#, 16#21#, 16#53#,
      16#EF#, 16#9D#, 16#0B#, 16#79#, 16#1E#, 16#6C#, 16#FA#, 16#88#,
      16#D2#, 16#A0#, 16#36#, 16#44#, 16#23#, 16#51#, 16#C7#, 16#B5#,
      16#09#, 16#7B#, 16#ED#, 16#9F#, 16#F8#, 16#8A#, 16#1C#, 16#6E#,
      16#5D#, 16#2F#, 16#B9#, 16#CB#, 16#AC#, 16#DE#, 16#48#, 16#3A#,
      16#86#, 16#F4#, 16#62#, 16#10#, 16#77#, 16#05#, 16#93#, 16#E1#,
      16#F5#, 16#87#, 16#11#, 16#63#, 16#04#, 16#76#, 16#E0#, 16#92#,
      16#2E#, 16#5C#, 16#CA#, 16#B8#, 16#DF#, 16#AD#, 16#3B#, 16#49#,
      16#7A#, 16#08#, 16#9E#, 16#EC#, 16#8B#, 16#F9#, 16#6F#, 16#1D#,
      16#A1#, 16#D3#, 16#45#, 16#37#, 16#50#, 16#22#, 16#B4#, 16#C6#);

   function Next (Sum : Byte; Data : Byte) return Byte is
     (Products (Sum xor Data));

   procedure Same_Bytes_Same_Sum
     (Header      : Byte;
      Left, Right : Block_Data;
      Length      : Byte_Count)
   is
      --  Ignored at run time: otherwise it takes a third of the time of a
      --  flight with contracts.
      pragma Assertion_Policy (Loop_Invariant => Ignore);
   begin
      for Last in 0 .. Length loop
         pragma Loop_Invariant
           (Of_Message (Header, Left, Last)
            = Of_Message (Header, Right, Last));
      end loop;
   end Same_Bytes_Same_Sum;

end Telemetry.Checksum;
