--  SPDX-License-Identifier: Apache-2.0

--  Signals of the system: the user wants the program to end.

package Sim.Signals is

   --  A process that is started between the two calls ignores an interrupt
   --  from the keyboard from its very beginning. This program gets one that
   --  comes between them afterwards.
   procedure Begin_Deafness;
   procedure End_Deafness;

   --  From now on an interrupt from the keyboard, or a request to end (SIGINT,
   --  SIGTERM), is only remembered. The third of a kind ends the program at
   --  once, for an impatient user; not the second, because some programs send
   --  each twice. A signal that was ignored when the program started stays
   --  ignored.
   procedure Watch;

   --  True if a signal has arrived.
   function Interrupted return Boolean with Inline;

end Sim.Signals;
