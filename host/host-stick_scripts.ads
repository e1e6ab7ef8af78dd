--  SPDX-License-Identifier: Apache-2.0

--  The pilot's sticks and switches, from a file (--sticks).

with Host.Names;
with Host.Scripts;

package Host.Stick_Scripts is new Host.Scripts
  (Item    => Command_Item,
   Words   => Console_Words,
   Neutral => Neutral_Console,
   Name    => Host.Names.Name);
