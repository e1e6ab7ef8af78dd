--  SPDX-License-Identifier: Apache-2.0

--  The history of a mailbox: what comes out of any sequence of sends, looks
--  and receives (MBX-2 to MBX-4, D-21).
--
--  Whoever share a mailbox, its protected object puts their calls in a
--  sequence: so what holds for any sequence holds for any interleaving.
--
--  The message that is sent is the place of its SEND in the sequence, so
--  that no two are alike. A mailbox does not look into its messages: what
--  holds for these holds for all.

with URVOS.Mailboxes;

package Theorems.Histories with Pure, SPARK_Mode, Ghost is

   Longest : constant := 1_000_000;

   --  A step of the sequence; 0 is before all of them.
   type Step_Count is range 0 .. Longest;
   subtype Step is Step_Count range 1 .. Longest;

   --  Looking is what RECV with a wait does before its last look.
   type Operation is (Sends, Looks, Receives);

   type History is array (Step) of Operation;

   package Boxes is new URVOS.Mailboxes (Message => Step_Count, Neutral => 0);
   use Boxes;

   --  What a step gave: a send, that it replaced nothing; else that the
   --  message was fresh, and which it was.
   type Outcome is record
      Success : Boolean;
      Message : Step_Count;
   end record;

   type Outcomes is array (Step) of Outcome;

   --  A step that gives a message to the consumer.
   function Consumes (What : Operation) return Boolean is (What /= Sends)
   with Global => null;

   --  The last step up to a step that sent, 0 if none did.
   function Last_Sent
     (Item : History; Upto : Step_Count) return Step_Count
   is
     (if Upto = 0 then 0
      elsif Item (Upto) = Sends then Upto
      else Last_Sent (Item, Upto - 1))
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Upto),
     Post               => Last_Sent'Result <= Upto;

   --  The last step up to a step that consumed, 0 if none did.
   function Last_Consumed
     (Item : History; Upto : Step_Count) return Step_Count
   is
     (if Upto = 0 then 0
      elsif Consumes (Item (Upto)) then Upto
      else Last_Consumed (Item, Upto - 1))
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Upto),
     Post               => Last_Consumed'Result <= Upto;

   --  What a mailbox that is new at first gives at a step.
   function Is_Given
     (Item : History; Now : Step; Gave : Outcome) return Boolean
   is
     (Gave.Message =
        (if Item (Now) = Sends then Now else Last_Sent (Item, Now - 1))
      and then Gave.Success =
        (if Item (Now) = Sends
         then Last_Sent (Item, Now - 1) <= Last_Consumed (Item, Now - 1)
         else Last_Sent (Item, Now - 1) > Last_Consumed (Item, Now - 1)))
   with Global => null;

   --  All steps up to one have given what a mailbox gives.
   function Is_Given_Upto
     (Item : History; Gave : Outcomes; Upto : Step_Count) return Boolean
   is
     (for all Now in Step range 1 .. Upto => Is_Given (Item, Now, Gave (Now)))
   with Global => null;

   --  A step at which a message was received fresh.
   function Is_Fresh_At
     (Item : History; Gave : Outcomes; Now : Step) return Boolean
   is
     (Consumes (Item (Now)) and then Gave (Now).Success)
   with Global => null;

   --  A mailbox gives the newest message that was sent, and gives it as
   --  fresh exactly when it was sent after the last message was taken: for
   --  any sequence of operations, done with the mailbox of the kernel.
   procedure Mailbox_Gives_The_Newest
     (Item : History;
      Upto : Step_Count;
      Gave : out Outcomes)
   with
     Global => null,
     Post   => Is_Given_Upto (Item, Gave, Upto);

   --  The last step that sent is one that sent, and none since did.
   procedure Last_Sent_Is_The_Last
     (Item : History; Upto : Step_Count; Since : Step)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Upto),
     Pre                => Since <= Upto,
     Post               =>
       (if Last_Sent (Item, Upto) > 0
        then Item (Last_Sent (Item, Upto)) = Sends)
       and then
         (if Since > Last_Sent (Item, Upto) then Item (Since) /= Sends);

   --  None that consumes comes after the last step that consumed.
   procedure Last_Consumed_Is_The_Last
     (Item : History; Upto : Step_Count; Since : Step)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Upto),
     Pre                => Since <= Upto,
     Post               =>
       (if Last_Consumed (Item, Upto) > 0
        then Consumes (Item (Last_Consumed (Item, Upto))))
       and then
         (if Since > Last_Consumed (Item, Upto)
          then not Consumes (Item (Since)));

   --  None is received that was not sent: a message that is received is the
   --  neutral one, or one that was sent before; fresh, it was sent.
   procedure What_Is_Received_Was_Sent
     (Item : History;
      Gave : Outcomes;
      Now  : Step)
   with
     Global => null,
     Pre    =>
       Is_Given_Upto (Item, Gave, Now) and then Consumes (Item (Now)),
     Post   =>
       Gave (Now).Message < Now
       and then
         (if Gave (Now).Message > 0
          then Item (Gave (Now).Message) = Sends)
       and then (if Gave (Now).Success then Gave (Now).Message > 0);

   --  Each message is received fresh at most once, and in the order sent:
   --  what comes fresh later is another message, and was sent later.
   procedure Fresh_Once_And_In_Order
     (Item           : History;
      Gave           : Outcomes;
      Earlier, Later : Step)
   with
     Global => null,
     Pre    =>
       Earlier < Later
       and then Is_Given_Upto (Item, Gave, Later)
       and then Is_Fresh_At (Item, Gave, Earlier)
       and then Is_Fresh_At (Item, Gave, Later),
     Post   =>
       Gave (Earlier).Message < Gave (Later).Message
       and then Gave (Later).Message > Earlier;

   --  None is lost but by a newer one: if something was sent before a
   --  receive, then that, or what was sent after it, was given fresh: at
   --  this receive or at one between.
   procedure None_Is_Lost_But_Overwritten
     (Item      : History;
      Gave      : Outcomes;
      Sent, Now : Step;
      Taken     : out Step)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Now),
     Pre                =>
       Sent < Now
       and then Is_Given_Upto (Item, Gave, Now)
       and then Item (Sent) = Sends
       and then Consumes (Item (Now)),
     Post               =>
       Taken in Sent + 1 .. Now
       and then Is_Fresh_At (Item, Gave, Taken)
       and then Gave (Taken).Message >= Sent;

   --  An old message that is given once more is the one that was given
   --  last, or the neutral one before any was: nothing came between.
   procedure Old_Is_The_Last_Given
     (Item           : History;
      Gave           : Outcomes;
      Earlier, Later : Step)
   with
     Global => null,
     Pre    =>
       Earlier < Later
       and then Is_Given_Upto (Item, Gave, Later)
       and then Consumes (Item (Later))
       and then not Gave (Later).Success
       and then Earlier = Last_Consumed (Item, Later - 1),
     Post   => Gave (Later).Message = Gave (Earlier).Message;

end Theorems.Histories;
