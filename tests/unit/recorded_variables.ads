--  Stands for a variable between two tasks: gives the task under test what
--  the test has put into Given, and keeps what it was sent last.

generic
   type Message is private;
   Neutral : Message;
package Recorded_Variables is

   --  What Receive gives, and how often it was called.
   Given    : Message := Neutral;
   Is_Fresh : Boolean := True;
   Received : Natural := 0;

   --  What Send was given last, what it answers, how often it was called.
   Kept     : Message := Neutral;
   Succeeds : Boolean := True;
   Sent     : Natural := 0;

   procedure Receive (Item : out Message; Fresh : out Boolean);

   procedure Send (Item : Message; Success : out Boolean);

   procedure Clear;

end Recorded_Variables;
