--  SPDX-License-Identifier: Apache-2.0

package body Tapes is

   type Channel_Words is array (0 .. 31) of Unsigned_16;

   type Tape_Entry is record
      Tick  : Unsigned_32;
      Kind  : Unsigned_32;   --  0 words, 1 and 2 events
      Words : Channel_Words;
   end record;

   Entries : array (Unsigned_32 range 0 .. 6_000) of Tape_Entry
   with Import, Volatile, Address => To_Address (16#0808_0018#);

   Next    : Unsigned_32 := 0;
   Present : Unsigned_32 := 0;
   Waiting : Event       := None with Volatile;

   procedure Advance (Tick : Unsigned_32) is
   begin
      while Next < Tape.Entries and then Entries (Next).Tick <= Tick loop
         case Entries (Next).Kind is
            when 0      => Present := Next;
            when 1      => Waiting := Illegal_Instruction;
            when others => Waiting := Unexpected_Interrupt;
         end case;
         Next := Next + 1;
      end loop;
   end Advance;

   function Word_Now (Channel : Natural) return Unsigned_16 is
     (Entries (Present).Words (Channel));

   function Event_Now return Event is (Waiting);

   procedure Forget_Event is
   begin
      Waiting := None;
   end Forget_Event;

end Tapes;
