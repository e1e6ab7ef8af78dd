--  SPDX-License-Identifier: Apache-2.0

--  What the system tells the program in the middle of its work: that the
--  user wants it to end.

package Sim.Signals is

   --  A process that is started between the two calls does not heed an
   --  interrupt from the keyboard, not even before it could say so itself.
   procedure Begin_Deafness;
   procedure End_Deafness;

   --  From now on an interrupt from the keyboard, or a request to end
   --  (SIGINT, SIGTERM), is only remembered. The third of a kind ends the
   --  program at once, for a user who will not wait; not the second, for
   --  some programs send each twice. One that the program was started to
   --  ignore stays ignored.
   procedure Watch;

   --  Whether one has come.
   function Interrupted return Boolean with Inline;

end Sim.Signals;
