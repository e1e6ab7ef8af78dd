--  SPDX-License-Identifier: Apache-2.0

--  The state of an MC68681 as its data sheet describes it, for contracts
--  (BRD-6, D-92). Between two accesses of the program characters arrive, the
--  sender becomes free and the timer's periods end: each Follows permits that.

package MC68681.Models with Pure, SPARK_Mode is

   --  The receiver holds three characters; a fourth waits in its shift
   --  register.
   Receiver_Places : constant := 3;

   --  A channel

   type Port_Model is record
      First_Mode      : Mode_1;
      Second_Mode     : Mode_2;
      Second_Is_Next  : Boolean;   --  the next access is to mode register 2
      Clocks          : Byte;
      Receiver_Is_On  : Boolean;
      Sender_Is_On    : Boolean;

      --  The oldest character held, by its number since power up, and the
      --  number of characters held.
      Oldest          : Event_Number;
      Held            : Natural;

      --  Characters lost since power up, and the flag. A loss sets it.
      Losses          : Event_Number;
      Overrun         : Boolean;

      --  The number of times when a set flag was reset.
      Overrun_Resets  : Event_Number;

      --  The errors of the oldest character were reset, too: the status does
      --  not show them.
      Errors_Are_Gone : Boolean;

      Takes_Character : Boolean;

      --  Characters given to the sender, and the last one of them.
      Sent            : Event_Number;
      Last_Sent       : Byte;
   end record;

   --  Both have the same modes, and both parts are on or off in both.
   function Same_Settings (One, Other : Port_Model) return Boolean is
     (One.First_Mode = Other.First_Mode
      and then One.Second_Mode = Other.Second_Mode
      and then One.Second_Is_Next = Other.Second_Is_Next
      and then One.Clocks = Other.Clocks
      and then One.Receiver_Is_On = Other.Receiver_Is_On
      and then One.Sender_Is_On = Other.Sender_Is_On);

   function Follows (After, Before : Port_Model) return Boolean is
     (Same_Settings (After, Before)
      and then After.Oldest = Before.Oldest
      and then After.Held in Before.Held .. Receiver_Places
      and then
        (if not Before.Receiver_Is_On
         then After.Held = Before.Held and then After.Losses = Before.Losses)
      and then (if Before.Overrun then After.Overrun)
      and then (if After.Losses /= Before.Losses then After.Overrun)
      and then After.Overrun_Resets = Before.Overrun_Resets
      and then After.Errors_Are_Gone = Before.Errors_Are_Gone
      and then (if Before.Takes_Character then After.Takes_Character)
      and then After.Sent = Before.Sent
      and then After.Last_Sent = Before.Last_Sent);

   function Is_Off (Port : Port_Model) return Boolean is
     (not Port.Receiver_Is_On and then not Port.Sender_Is_On);

   --  A channel after the program's accesses

   function With_Mode (Port : Port_Model; Mode : Mode_1) return Port_Model is
     ((Port with delta First_Mode => Mode, Second_Is_Next => True));

   function With_Mode (Port : Port_Model; Mode : Mode_2) return Port_Model is
     ((Port with delta Second_Mode => Mode));

   function With_Clocks (Port : Port_Model; Clocks : Byte) return Port_Model
   is
     ((Port with delta Clocks => Clocks));

   function Without_Oldest (Port : Port_Model) return Port_Model is
     ((Port with delta
         Oldest          => Port.Oldest + 1,
         Held            => Port.Held - 1,
         Errors_Are_Gone => False))
   with Pre => Port.Held > 0;

   function With_Character (Port : Port_Model; Data : Byte) return Port_Model
   is
     ((Port with delta
         Takes_Character => False,
         Sent            => Port.Sent + 1,
         Last_Sent       => Data));

   --  The result of a command. A reset of the errors resets those of the
   --  oldest character, too, also of one that arrives just before. A character
   --  may be lost just before, and its flag is reset.
   function Obeys
     (After, Before : Port_Model;
      Order         : Command) return Boolean
   is
     (case Order is
         when Switch_On_Sender   =>
            Follows (After, (Before with delta Sender_Is_On => True)),
         when Switch_On_Both     =>
            Follows
              (After,
               (Before with delta
                  Receiver_Is_On => True, Sender_Is_On => True)),
         when Reset_Mode_Pointer =>
            Follows (After, (Before with delta Second_Is_Next => False)),
         when Reset_Receiver     =>
            Same_Settings (After, (Before with delta Receiver_Is_On => False))
            and then After.Held = 0
            and then not After.Errors_Are_Gone,
         when Reset_Sender       =>
            Same_Settings (After, (Before with delta Sender_Is_On => False))
            and then After.Oldest = Before.Oldest
            and then After.Held >= Before.Held
            and then
              (if not Before.Receiver_Is_On then After.Held = Before.Held)
            and then After.Errors_Are_Gone = Before.Errors_Are_Gone,
         when Reset_Errors       =>
            Follows
              (After,
               (Before with delta
                  Overrun         => After.Overrun,
                  Losses          => After.Losses,
                  Overrun_Resets  => After.Overrun_Resets,
                  Errors_Are_Gone => After.Errors_Are_Gone))
            and then (if After.Errors_Are_Gone then After.Held > 0)
            and then
              (if Before.Overrun
               then After.Overrun_Resets = Before.Overrun_Resets + 1));

   --  The status register of a channel whose oldest character is this one.
   function Shows
     (Status : Channel_Status;
      Port   : Port_Model;
      Oldest : Heard_Character) return Boolean
   is
     (Status.Received = (Port.Held > 0)
      and then Status.Is_Full = (Port.Held = Receiver_Places)
      and then Status.Takes_Character = Port.Takes_Character
      and then Has (Status.Errors, Overrun) = Port.Overrun
      and then
        (if Status.Received and then not Port.Errors_Are_Gone
         then Has (Status.Errors, Wrong_Parity) = Oldest.Wrong_Parity
           and then Has (Status.Errors, Wrong_Framing) = Oldest.Wrong_Framing
           and then Has (Status.Errors, Is_Break) = Oldest.Is_Break));

   --  A chip: timer and interrupts

   type Chip_Model is record
      Interrupts : Interrupt_Set;
      Vector     : Byte;
      Auxiliary  : Byte;
      High, Low  : Count_Half;   --  of the count
      Runs       : Boolean;

      --  Periods that have ended since power up, and the flag. The end of a
      --  period sets it.
      Periods    : Event_Number;
      Is_Due     : Boolean;

      --  The number of times when a set flag was reset.
      Due_Resets : Event_Number;
   end record;

   function Count_Of (Chip : Chip_Model) return Natural is
     (Natural (Chip.High) * 256 + Natural (Chip.Low));

   function Follows (After, Before : Chip_Model) return Boolean is
     (After.Interrupts = Before.Interrupts
      and then After.Vector = Before.Vector
      and then After.Auxiliary = Before.Auxiliary
      and then After.High = Before.High
      and then After.Low = Before.Low
      and then After.Runs = Before.Runs
      and then (if Before.Is_Due then After.Is_Due)
      and then (if After.Periods /= Before.Periods then After.Is_Due)
      and then After.Due_Resets = Before.Due_Resets);

   --  A read of the stop register resets the flag. The timer runs on. The end
   --  of a period just before is reset, too.
   function Is_Answered (After, Before : Chip_Model) return Boolean is
     (Follows
        (After,
         (Before with delta
            Is_Due     => After.Is_Due,
            Periods    => After.Periods,
            Due_Resets => After.Due_Resets))
      and then
        (if Before.Is_Due
         then After.Due_Resets = Before.Due_Resets + 1));

end MC68681.Models;
