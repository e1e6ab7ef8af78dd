--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Interfaces.C;                 use Interfaces.C;

with GSC;
with Partitions.Clocks;
with Partitions.Console;
with Partitions.Console_Port;
with Partitions.Frame_Packets; use Partitions.Frame_Packets;
with Partitions.Links;
with Partitions.Octets;
with Partitions.Peer_Watch;    use Partitions.Peer_Watch;
with Partitions.Sockets;
with Partitions.System_Calls;  use Partitions.System_Calls;
with URV.Buffers;              use URV.Buffers;
with URV.CORE_Memory;          use URV.CORE_Memory;

package body Partitions.Publisher is

   use type Octets.Number;

   --  The columns of the values that the packet takes from a row: see
   --  Partitions.Nodes.Observe_Frame and Partitions.Console.Append_Values.
   Frame_Column          : constant Column := 1;
   First_Word_Column     : constant Column := 3;
   Downlink_Error_Column : constant Column := First_Word_Column + Word_Count
                                              - 1;
   First_Count_Column    : constant Column := Downlink_Error_Column + 1;
   Received_Column       : constant Column := First_Count_Column + 2;
   Overruns_Column       : constant Column := First_Count_Column + 5;

   Places : array (1 .. Most_Places) of File := (others => Invalid);
   Number_Of_Places : Natural        := 0;
   Version_Chosen   : Version_Number := 1;

   --  Used by the task that takes the rows.
   Fresh_At : Octets.Number := 0;
   Is_Seen  : Boolean := False;

   --  In microseconds: a machine without a clock of its own begins with the
   --  same second each time.
   Run : constant Octets.Number := Clocks.UTC mod 2 ** 32;

   Unsent : Count := 0 with Atomic;

   --  The queue to the sender: enough for a second.
   Capacity : constant := 50;
   type Slot is mod Capacity;
   type Packet_Array is array (Slot) of Packet;

   --  The sender waits for it when it has found the queue empty.
   Row_Waiting : Suspension_Object;

   protected Queue is

      --  Is_Taken is False when there is no room.
      procedure Put (Item : Packet; Is_Taken : out Boolean);

      --  Found is False when the queue is empty; otherwise Done must be called
      --  when the packet has been sent.
      procedure Take (Item : out Packet; Found : out Boolean);
      procedure Done;

      function Is_Empty return Boolean;

   private
      Packets : Packet_Array;
      First   : Slot    := 0;
      Length  : Natural := 0;
      Sending : Boolean := False;
   end Queue;

   protected Missing is
      procedure Add (Number : Count);
   end Missing;

   protected body Queue is

      procedure Put (Item : Packet; Is_Taken : out Boolean) is
      begin
         Is_Taken := Length < Capacity;
         if Is_Taken then
            Packets (First + Slot'Mod (Length)) := Item;
            Length := Length + 1;
            Set_True (Row_Waiting);
         end if;
      end Put;

      procedure Take (Item : out Packet; Found : out Boolean) is
      begin
         Item := Packets (First);
         Found := Length > 0;
         if Found then
            First := First + 1;
            Length := Length - 1;
            Sending := True;
         end if;
      end Take;

      procedure Done is
      begin
         Sending := False;
      end Done;

      function Is_Empty return Boolean is (Length = 0 and then not Sending);

   end Queue;

   protected body Missing is

      procedure Add (Number : Count) is
      begin
         for Each in 1 .. Number loop
            Unsent := Incremented (Unsent);
         end loop;
      end Add;

   end Missing;

   procedure Choose (Version : Version_Number) is
   begin
      Version_Chosen := Version;
   end Choose;

   procedure Open (Place : String) is
   begin
      Places (Number_Of_Places + 1) := Sockets.Sender ("--publish", Place);
      Number_Of_Places := Number_Of_Places + 1;
   end Open;

   --  The number of frames without a fresh downlink.
   procedure Look_At_Downlink (Item : Row; Age : out Octets.Number);

   function Counts_In (Item : Row) return Link_Counts;

   procedure Look_At_Downlink (Item : Row; Age : out Octets.Number) is
      Frame    : constant Octets.Number := Item.Value (Frame_Column);
      Is_Fresh : constant Boolean :=
        (Item.Value (Downlink_Error_Column)
         and Octets.Number (Stale_Data)) = 0
        and then Item.Value (Received_Column) > 0;
   begin
      if Is_Fresh then
         Is_Seen := True;
         Fresh_At := Frame;
      end if;
      Age := (if Is_Seen then Octets.Number'Min (Frame - Fresh_At, Never - 1)
              else Never);
   end Look_At_Downlink;

   function Counts_In (Item : Row) return Link_Counts is
      function At_Place (Offset : Column) return Octets.Number is
        (Item.Value (First_Count_Column + Offset));
   begin
      return
        (Uplink_Sent       => At_Place (0),
         Uplink_Scrapped   => At_Place (1),
         Downlink_Received => At_Place (2),
         Downlink_Bad      => At_Place (3),
         Resets            => At_Place (4),
         Bytes_Discarded   => Octets.Number (Links.Discarded),
         Overruns          => Item.Value (Overruns_Column),
         Publish_Not_Sent  => Octets.Number (Unsent),
         Console_Packets   => Octets.Number (Console_Port.Taken),
         Console_Bad       => Octets.Number (Console_Port.Dropped));
   end Counts_In;

   procedure Publish (Item : Row) is
      CORE     : constant Memory         := GSC.CORE_Memory.Contents;
      Sticks   : constant Console.Sticks := Console.Recorded;
      Age      : Octets.Number;
      Words    : Word_List;
      Is_Taken : Boolean;
   begin
      if Number_Of_Places = 0 then
         return;
      end if;
      Look_At_Downlink (Item, Age);
      for Place in Words'Range loop
         Words (Place) := Item.Value (First_Word_Column + Column (Place) - 1);
      end loop;
      Queue.Put
        (To_Packet
           ((Run              => Run,
             Sequence         => Item.Value (Frame_Column),
             Time             => Clocks.UTC,
             Downlink_Age     => Age,
             Console_State    =>
               Console.Console_State'Pos (Sticks.State),
             Link_State       => Peer_State'Pos (Item.Peer),
             Console_Sequence => Sticks.Sequence,
             Counts           => Counts_In (Item),
             Words            => Words,
             Log              => CORE.Log,
             Aircraft_Log     => CORE.Aircraft_Log,
             Status           => CORE.Status,
             Pilot            => Console.Pilot_State'Pos (Sticks.Pilot),
             Downlink_Frame   => CORE.Frame),
            Version_Chosen),
         Is_Taken);
      if not Is_Taken then
         Missing.Add (Count (Number_Of_Places));
      end if;
   end Publish;

   procedure Send_All (Item : Packet);

   procedure Send_All (Item : Packet) is
      Length : constant Positive := Host.Frame_Layout.Length (Version_Chosen);
      Sent   : Byte_Total;
   begin
      for Place of Places (1 .. Number_Of_Places) loop

         --  A socket first reports that an earlier datagram was refused: it
         --  had no receiver.
         for Attempt in 1 .. 2 loop
            Sent := Send
              (Place, Item'Address, size_t (Length),
               Dont_Wait + No_Signal);
            exit when Sent >= 0;
         end loop;
         if Sent /= Byte_Total (Length) then
            Missing.Add (1);
         end if;
      end loop;
   end Send_All;

   task Sender;

   task body Sender is
      Item  : Packet;
      Found : Boolean;
   begin
      loop
         Queue.Take (Item, Found);
         if Found then
            Send_All (Item);
            Queue.Done;
         else
            Suspend_Until_True (Row_Waiting);
         end if;
      end loop;
   end Sender;

   procedure Finish is
      Look_Again : constant Ada.Real_Time.Time_Span := Milliseconds (2);
      Looks      : constant := 500;
   begin
      for Look in 1 .. Looks loop
         exit when Queue.Is_Empty;
         delay until Clock + Look_Again;
      end loop;
   end Finish;

   function Not_Sent return Count is (Unsent);

end Partitions.Publisher;
