--  SPDX-License-Identifier: Apache-2.0

--  The tape of an emulated flight, at an address of the ROM where the emulator
--  loads it: settings, the converter's words from given ticks on, and faults
--  of the processor.

with Interfaces;              use Interfaces;
with System.Storage_Elements; use System.Storage_Elements;

package Tapes is

   type Header is record
      Lag        : Unsigned_32;   --  ticks until the node's clock begins
      Quantum    : Unsigned_32;   --  character times, up to 16; 0: no line
      Line_Delay : Unsigned_32;   --  in microseconds, for the boards
      Flags      : Unsigned_32;   --  1: control laws on; 2: sealed link
      Length     : Unsigned_32;   --  of the flight, in character times
      Entries    : Unsigned_32;
   end record;

   Tape : Header
   with Import, Volatile, Address => To_Address (16#0808_0000#);

   type Event is (None, Illegal_Instruction, Unexpected_Interrupt);

   --  Moves the tape to this tick of the clock.
   procedure Advance (Tick : Unsigned_32);

   --  The present word of a channel.
   function Word_Now (Channel : Natural) return Unsigned_16
   with Pre => Channel < 32;

   --  A fault that is due but has not happened yet.
   function Event_Now return Event;

   procedure Forget_Event;

end Tapes;
