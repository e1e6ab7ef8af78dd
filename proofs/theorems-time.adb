--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Time with SPARK_Mode is

   procedure Clock_Advances (Now : Clock_Tick) is null;

   procedure Release_Is_In_Next_Frame
     (Now : Clock_Tick; Offset : Minor_Frame) is null;

   procedure Frame_Has_One_Successor (Now : Clock_Tick) is null;

   procedure Nothing_Is_Released_After_The_Last_Tick
     (Offset : Minor_Frame) is null;

end Theorems.Time;
