--  SPDX-License-Identifier: Apache-2.0

--  A mailbox gives its consumer the newest message, each message once as
--  fresh, in the order sent, and loses one only to a newer one (MBX-2 to
--  MBX-4, D-21). This holds for the kernel's mailbox over any sequence of up
--  to a million sends, looks and receives, from a new mailbox. The protected
--  object of a shared mailbox puts all calls in such a sequence, so it holds
--  for any interleaving of the tasks.
--
--  Here the message is the number of the SEND's step, so no two messages are
--  equal. A mailbox does not look into its messages; a property of these
--  therefore holds for all.

with URVOS.Mailboxes;

package Theorems.Histories with Pure, SPARK_Mode, Ghost is

   Longest : constant := 1_000_000;

   --  A step of the sequence; 0 is before all steps.
   type Step_Count is range 0 .. Longest;
   subtype Step is Step_Count range 1 .. Longest;

   --  A look is a RECV's look before its last one.
   type Operation is (Sends, Looks, Receives);

   type History is array (Step) of Operation;

   package Boxes is new URVOS.Mailboxes (Message => Step_Count, Neutral => 0);
   use Boxes;

   --  The result of a step. Success of a send: it replaced no message; of the
   --  others: the message was fresh.
   type Outcome is record
      Success : Boolean;
      Message : Step_Count;
   end record;

   type Outcomes is array (Step) of Outcome;

   --  The step gives a message to the consumer.
   function Consumes (What : Operation) return Boolean is (What /= Sends)
   with Global => null;

   --  The last step up to Up_To that sent; 0 if none did.
   function Last_Sent
     (Item : History; Up_To : Step_Count) return Step_Count
   is
     (if Up_To = 0 then 0
      elsif Item (Up_To) = Sends then Up_To
      else Last_Sent (Item, Up_To - 1))
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Up_To),
     Post               => Last_Sent'Result <= Up_To;

   --  The last step up to Up_To that consumed; 0 if none did.
   function Last_Consumed
     (Item : History; Up_To : Step_Count) return Step_Count
   is
     (if Up_To = 0 then 0
      elsif Consumes (Item (Up_To)) then Up_To
      else Last_Consumed (Item, Up_To - 1))
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Up_To),
     Post               => Last_Consumed'Result <= Up_To;

   --  The result at a step of a mailbox that was new at first.
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

   --  All steps up to one have a mailbox's results.
   function Is_Given_Up_To
     (Item : History; Gave : Outcomes; Up_To : Step_Count) return Boolean
   is
     (for all Now in Step range 1 .. Up_To => Is_Given (Item, Now, Gave (Now)))
   with Global => null;

   --  A step at which a message was received fresh.
   function Is_Fresh_At
     (Item : History; Gave : Outcomes; Now : Step) return Boolean
   is
     (Consumes (Item (Now)) and then Gave (Now).Success)
   with Global => null;

   --  The kernel's mailbox gives the newest message, as fresh exactly if it
   --  was sent after the last message was taken, for any sequence.
   procedure Mailbox_Gives_The_Newest
     (Item  : History;
      Up_To : Step_Count;
      Gave  : out Outcomes)
   with
     Global => null,
     Post   => Is_Given_Up_To (Item, Gave, Up_To);

   --  Last_Sent is a step that sent, and no later one up to Up_To did.
   procedure Last_Sent_Is_The_Last
     (Item : History; Up_To : Step_Count; Since : Step)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Up_To),
     Pre                => Since <= Up_To,
     Post               =>
       (if Last_Sent (Item, Up_To) > 0
        then Item (Last_Sent (Item, Up_To)) = Sends)
       and then
         (if Since > Last_Sent (Item, Up_To) then Item (Since) /= Sends);

   --  No step that consumes comes after Last_Consumed.
   procedure Last_Consumed_Is_The_Last
     (Item : History; Up_To : Step_Count; Since : Step)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Up_To),
     Pre                => Since <= Up_To,
     Post               =>
       (if Last_Consumed (Item, Up_To) > 0
        then Consumes (Item (Last_Consumed (Item, Up_To))))
       and then
         (if Since > Last_Consumed (Item, Up_To)
          then not Consumes (Item (Since)));

   --  Each message received is the neutral one or was sent before. A fresh one
   --  was sent before.
   procedure A_Received_Message_Was_Sent
     (Item : History;
      Gave : Outcomes;
      Now  : Step)
   with
     Global => null,
     Pre    =>
       Is_Given_Up_To (Item, Gave, Now) and then Consumes (Item (Now)),
     Post   =>
       Gave (Now).Message < Now
       and then
         (if Gave (Now).Message > 0
          then Item (Gave (Now).Message) = Sends)
       and then (if Gave (Now).Success then Gave (Now).Message > 0);

   --  Each message is received fresh at most once, in the order sent: a later
   --  fresh message is another one, sent later.
   procedure Fresh_Once_And_In_Order
     (Item           : History;
      Gave           : Outcomes;
      Earlier, Later : Step)
   with
     Global => null,
     Pre    =>
       Earlier < Later
       and then Is_Given_Up_To (Item, Gave, Later)
       and then Is_Fresh_At (Item, Gave, Earlier)
       and then Is_Fresh_At (Item, Gave, Later),
     Post   =>
       Gave (Earlier).Message < Gave (Later).Message
       and then Gave (Later).Message > Earlier;

   --  A message is lost only to a newer one: if one was sent before a receive,
   --  then it or a later one was given fresh, at this receive or between.
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
       and then Is_Given_Up_To (Item, Gave, Now)
       and then Item (Sent) = Sends
       and then Consumes (Item (Now)),
     Post               =>
       Taken in Sent + 1 .. Now
       and then Is_Fresh_At (Item, Gave, Taken)
       and then Gave (Taken).Message >= Sent;

   --  An old message given again is the last one given, or the neutral one
   --  before any. No message came between.
   procedure Old_Is_The_Last_Given
     (Item           : History;
      Gave           : Outcomes;
      Earlier, Later : Step)
   with
     Global => null,
     Pre    =>
       Earlier < Later
       and then Is_Given_Up_To (Item, Gave, Later)
       and then Consumes (Item (Later))
       and then not Gave (Later).Success
       and then Earlier = Last_Consumed (Item, Later - 1),
     Post   => Gave (Later).Message = Gave (Earlier).Message;

end Theorems.Histories;
