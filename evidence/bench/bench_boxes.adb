--  SPDX-License-Identifier: Apache-2.0

package body Bench_Boxes is

   Sent : Bytes := (others => 1);
   Got  : Bytes;

   procedure Exchange (Turn : Positive) is
      Success : Boolean;
      Fresh   : Boolean;
   begin
      Sent (1) := Byte (Turn mod 256);
      Box.Send (Sent, Success);
      Box.Receive (Got, Fresh);
      if not Success or else not Fresh or else Got (1) /= Sent (1) then
         raise Program_Error;
      end if;
   end Exchange;

end Bench_Boxes;
