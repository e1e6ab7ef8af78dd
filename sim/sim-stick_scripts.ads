--  What the pilot's sticks and switches do, from a file (--sticks).

with Sim.Names;
with Sim.Scripts;

package Sim.Stick_Scripts is new Sim.Scripts
  (Item    => Command_Item,
   Words   => Console_Words,
   Neutral => Neutral_Console,
   Name    => Sim.Names.Name);
