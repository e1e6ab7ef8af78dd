--  SPDX-License-Identifier: Apache-2.0

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Interfaces;                   use Interfaces;
with Interfaces.C;                 use Interfaces.C;

with Partitions.Clocks;
with Partitions.Console_Packets; use Partitions.Console_Packets;
with Partitions.Order_Packets;
with Partitions.Orders;
with Partitions.Recorder_Answers;
with Partitions.Sockets;
with Partitions.System_Calls;    use Partitions.System_Calls;
with URV.Buffers;                use URV.Buffers;
with URV.Type_Codes;             use URV.Type_Codes;

package body Partitions.Console_Port is

   Port : File := Invalid;
   Gate : Suspension_Object;

   --  After an error of the operating system.
   Rest : constant Ada.Real_Time.Time_Span := Milliseconds (10);

   protected Latest is

      --  Takes the packet as the latest one, unless another console has the
      --  sticks. Age is the time since it was made.
      procedure Take
        (Item : Packet; Now : Time; Age : Ada.Real_Time.Time_Span);

      --  The order is from the holder of the sticks, or there is no holder. It
      --  follows the sticks and the earlier orders.
      procedure Check_Order
        (Run      : Octets.Number;
         Sequence : Octets.Number;
         Now      : Time;
         Follows  : out Boolean);

      procedure Drop;

      function Contents (Now : Time) return Situation;

      function Number_Accepted return Count;
      function Number_Dropped return Count;

   private
      Item    : Packet;
      Made_At : Time    := Time_First;
      Any     : Boolean := False;
      Good    : Count   := 0;
      Bad     : Count   := 0;

      --  The sender of the last order that followed.
      Ordered_By : Octets.Number := 0;
      Ordered    : Octets.Number := 0;
   end Latest;

   protected body Latest is

      procedure Take
        (Item : Packet; Now : Time; Age : Ada.Real_Time.Time_Span)
      is
         Follows : constant Boolean :=
           (if Latest.Any and then Item.Run = Latest.Item.Run
            then Item.Sequence > Latest.Item.Sequence
            else Item.Sequence > 0
              and then (not Latest.Any
                        or else Now - Latest.Made_At >= Longest_Silence));
      begin
         if Follows then
            Latest.Item := Item;
            Latest.Made_At := Now - Age;
            Latest.Any := True;
            Good := Incremented (Good);
         else
            Bad := Incremented (Bad);
         end if;
      end Take;

      procedure Check_Order
        (Run      : Octets.Number;
         Sequence : Octets.Number;
         Now      : Time;
         Follows  : out Boolean) is
      begin
         Follows :=
           (if Any and then Run = Item.Run then Sequence > Item.Sequence
            else Sequence > 0
              and then (not Any or else Now - Made_At >= Longest_Silence))
           and then (Run /= Ordered_By or else Sequence > Ordered);
         if Follows then
            Ordered_By := Run;
            Ordered := Sequence;
         end if;
      end Check_Order;

      procedure Drop is
      begin
         Bad := Incremented (Bad);
      end Drop;

      function Contents (Now : Time) return Situation is
        (if Any
         then
           (Has_Come    => True,
            Silence     => Now - Made_At,
            Words       => Item.Words,
            Sequence    => Item.Sequence,
            Pilot_Flies => Item.Pilot_Flies)
         else (Pilot_Flies => True, others => <>));

      function Number_Accepted return Count is (Good);

      function Number_Dropped return Count is (Bad);

   end Latest;

   procedure Open (Place : String) is
   begin
      Port := Sockets.Loopback_Receiver ("--console", Place);
      Set_True (Gate);
   end Open;

   function Is_Open return Boolean is (Port /= Invalid);

   --  A packet needs a known age, not above the limit. One of the future was
   --  made before the machine's clock was set back, or with another clock: its
   --  waiting time is unknown (GND-59).
   function Is_Recent (Made_At, Now : Octets.Number) return Boolean is
     (Made_At <= Now and then Now - Made_At <= Octets.Number (Longest_Delay));

   type Sender is record
      Where  : Socket_Address := (others => 0);
      Length : unsigned       := Socket_Address'Length;
   end record;

   --  A datagram has arrived: sticks, or an order.
   procedure Take_In (Datagram : Octets.Octet_Array; From : Sender);
   procedure Take_Sticks (Datagram : Octets.Octet_Array);
   procedure Take_Order (Datagram : Octets.Octet_Array; From : Sender);

   --  A request for rows of the flight recorder moves nothing, so any sender
   --  may make one, not only the holder of the sticks. In flight it is refused
   --  here (FTI-10).
   procedure Take_Request
     (Block : Uplink_Buffer; From : Sender; Is_Taken : out Boolean);

   procedure Take_Request
     (Block : Uplink_Buffer; From : Sender; Is_Taken : out Boolean) is
   begin
      Recorder_Answers.Note_Sender (Port, From.Where, From.Length);
      Is_Taken := True;
      if Recorder_Answers.Is_Flying then
         Recorder_Answers.Refuse_In_Flight;
      else
         Orders.Give (Block, Is_Taken);
      end if;
   end Take_Request;

   procedure Take_In (Datagram : Octets.Octet_Array; From : Sender) is
   begin
      if Order_Packets.Is_Meant (Datagram) then
         Take_Order (Datagram, From);
      else
         Take_Sticks (Datagram);
      end if;
   end Take_In;

   procedure Take_Order (Datagram : Octets.Octet_Array; From : Sender) is
      Item     : Order_Packets.Packet;
      Is_Taken : Boolean;
   begin
      Order_Packets.Read (Datagram, Item, Is_Taken);
      Is_Taken :=
        Is_Taken
        and then Is_Recent (Item.Made_At, Now => Clocks.UTC);
      if Is_Taken and then Kind_Of (Item.Block) = Recorder_Kind then
         Take_Request (Item.Block, From, Is_Taken);
      elsif Is_Taken then
         Latest.Check_Order (Item.Run, Item.Sequence, Clock, Is_Taken);
         if Is_Taken then
            Orders.Give (Item.Block, Is_Taken);
         end if;
      end if;
      if not Is_Taken then
         Latest.Drop;
      end if;
   end Take_Order;

   procedure Take_Sticks (Datagram : Octets.Octet_Array) is
      Item     : Packet;
      Is_Valid : Boolean;
      Now      : constant Octets.Number := Clocks.UTC;
   begin
      Read (Datagram, Item, Is_Valid);
      if Is_Valid and then Is_Recent (Item.Made_At, Now) then
         Latest.Take
           (Item, Clock,
            Ada.Real_Time.Microseconds (Integer (Now - Item.Made_At)));
      else
         Latest.Drop;
      end if;
   end Take_Sticks;

   task Listener;

   task body Listener is
      --  Larger than a packet: a longer datagram is not a packet.
      Datagram : Octets.Octet_Array (1 .. 2 * Console_Packets.Length);
      Length   : Byte_Total;
      From     : Sender;
   begin
      Suspend_Until_True (Gate);
      loop
         From := (others => <>);
         Length := Receive_From
           (Port, Datagram'Address, Datagram'Length, 0, From.Where'Address,
            From.Length);
         if Length >= 0 then
            Take_In (Datagram (1 .. Natural (Length)), From);
         else
            delay until Clock + Rest;
         end if;
      end loop;
   end Listener;

   function Seen (At_Time : Time) return Situation is
     (Latest.Contents (At_Time));

   function Taken return Count is (Latest.Number_Accepted);

   function Dropped return Count is (Latest.Number_Dropped);

end Partitions.Console_Port;
