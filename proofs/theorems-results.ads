--  What an operation does follows from its contract alone (EVI-7): done
--  twice with the same inputs, it gives the same results. GNATprove knows of
--  a call nothing but the contract, so a postcondition that left something
--  open would not prove these.
--
--  Of functions the same need not be said: a postcondition that is an
--  expression, or an equation for each part of the result, shows it.

with Telemetry;
with Telemetry.Memory;
with URVOS;
with URVOS.Arrangements;
with URVOS.Error_Logs;
with URVOS.Frames;
with URVOS.Mailboxes;
with URVOS.ROM_Checks;
with URVOS.Semaphores;
with URVOS.Waits;
with URV.AD_Scans;

package Theorems.Results with Pure, SPARK_Mode, Ghost is

   use Telemetry;
   use Telemetry.Memory;
   use URVOS;
   use URVOS.Arrangements;
   use URVOS.Frames;
   use URVOS.Semaphores;
   use URVOS.Waits;
   use URV.AD_Scans;

   --  The kernel

   procedure Of_Move
     (Row      : Arrangement;
      From, To : Arrangements.Place;
      Same     : out Boolean)
   with
     Global => null,
     Pre    => Is_Sound (Row),
     Post   => Same;

   type Kind is (This, That);

   package Logs is new URVOS.Error_Logs (Kind);
   use Logs;

   procedure Of_Add
     (Log       : Error_Log;
      Which     : Kind;
      Now       : Clock_Tick;
      Detail    : Word;
      How_Often : Positive_Count;
      Same      : out Boolean)
   with
     Global => null,
     Post   => Same;

   package Boxes is new URVOS.Mailboxes (Word, 0);
   use Boxes;

   procedure Of_Send
     (Box  : Mailbox;
      Item : Word;
      Same : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Look (Box : Mailbox; Same : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Receive (Box : Mailbox; Same : out Boolean)
   with
     Global => null,
     Post   => Same;

   package Checks is new URVOS.ROM_Checks (Last => 16#FFFF#);
   use Checks;

   procedure Of_Take_Byte
     (Item : Check;
      Data : Byte;
      Same : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Try_Claim
     (Item   : Semaphore;
      Caller : Claimant;
      Same   : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Release
     (Item   : Semaphore;
      Caller : Claimant;
      Same   : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Note_Look
     (Item : Wait;
      Now  : Clock_Tick;
      Same : out Boolean)
   with
     Global => null,
     Pre    => not Is_Over (Item, Now),
     Post   => Same;

   --  The telemetry board

   procedure Of_Take (Pair : Buffer_Pair; Same : out Boolean)
   with
     Global => null,
     Post   => Same;

   procedure Of_Put
     (Pair : Buffer_Pair;
      Data : Block_Data;
      Same : out Boolean)
   with
     Global => null,
     Pre    =>
       (for all Which in Slot =>
          (if Pair.Slots (Which).Busy
           then Pair.Slots (Which).Full
             and then not Pair.Slots (Other (Which)).Busy)),
     Post   => Same;

   --  The tasks

   procedure Of_Store
     (Item  : Scan;
      Value : Word;
      Same  : out Boolean)
   with
     Global => null,
     Post   => Same;

end Theorems.Results;
