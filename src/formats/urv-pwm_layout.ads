--  SPDX-License-Identifier: Apache-2.0

--  The places of the outputs in the data area of the PWM board (report, 4.8,
--  figure 13b; PWM-2, D-13): the servos in order, then the discretes.

with Devices.PWM_Board; use Devices.PWM_Board;
with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;

package URV.PWM_Layout with Pure, SPARK_Mode is

   function Channel_Of (Item : PWM_Item) return Channel_Number is
     (Channel_Number (PWM_Item'Pos (Item) + 1))
   with Global => null;

   --  Unused channels are neutral.
   function To_Data_Area (Source : PWM_Buffer) return Data_Area
   with
     Global => null,
     Post   =>
       (for all Item in PWM_Item =>
          To_Data_Area'Result (Channel_Of (Item)) = Source (Item))
       and then
         (for all Unused in Channel_Number =>
            (if Unused > Channel_Of (PWM_Item'Last)
             then To_Data_Area'Result (Unused) = Neutral));

   --  The board's words from power up until the first commands (INI-3, SAF-1).
   function Safe_Area return Data_Area is (To_Data_Area (Safe_Outputs))
   with Global => null;

   --  The board's words when no controller has touched it for 0.5 s (SAF-11,
   --  D-34): the safe words, with the brake unchanged. In flight the brake was
   --  off; a locked wheel would upset the landing. Before a flight it was on.
   function Unattended_Area (Words : Data_Area) return Data_Area is
     ((Safe_Area with delta Channel_Of (Brake) => Words (Channel_Of (Brake))))
   with Global => null;

   function To_Outputs (Area : Data_Area) return PWM_Buffer
   with
     Global => null,
     Post   =>
       (for all Item in PWM_Item =>
          To_Outputs'Result (Item) = Area (Channel_Of (Item)));

end URV.PWM_Layout;
