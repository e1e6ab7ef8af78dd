--  SPDX-License-Identifier: Apache-2.0

with GNAT.OS_Lib;
with Interfaces;
with Interfaces.C; use Interfaces.C;
with System;

with Host.Complaints;         use Host.Complaints;
with Partitions.Error_Marks;
with Partitions.Flood_Guards;
with Partitions.Serial_Lines;
with Partitions.Sockets;
with Partitions.System_Calls; use Partitions.System_Calls;

package body Partitions.Links is

   UDP_Prefix    : constant String := "udp:";
   Serial_Prefix : constant String := "serial:";

   Line        : File    := Invalid;
   Wake_Events : File    := Invalid;
   Is_Serial   : Boolean := False;
   Marks       : Error_Marks.Mark_Reader;
   Lost        : Count   := 0 with Atomic;
   Thrown      : Count   := 0 with Atomic;

   --  The other end of a serial line has gone: there is no input to wait for.
   Is_Hung_Up : Boolean := False;

   Block_Length : constant := 1_024;
   Block : array (1 .. Block_Length) of Byte;

   --  The operating system may report that together with input and errors.
   function Has_Hung_Up (Request : Poll_Request) return Boolean is
     (Request.Found / Hung_Up mod 2 = 1);

   function Starts_With (Text, Prefix : String) return Boolean is
     (Text'Length > Prefix'Length
      and then Text (Text'First .. Text'First + Prefix'Length - 1) = Prefix);

   procedure Open (Argument : String) is
   begin
      Wake_Events := Event_File (0, Non_Blocking);
      if Starts_With (Argument, UDP_Prefix) then
         Line := Sockets.Opened
           (Argument (Argument'First + UDP_Prefix'Length .. Argument'Last));
      elsif Starts_With (Argument, Serial_Prefix) then
         Is_Serial := True;
         Line := Serial_Lines.Opened
           (Argument
              (Argument'First + Serial_Prefix'Length .. Argument'Last));
      else
         Refuse
           ("--link: " & Quoted (Argument)
            & " is neither udp:HOST:PORT:PEER_HOST:PEER_PORT"
            & " nor serial:DEVICE");
      end if;
   end Open;

   function Limit_Of (Span : Ada.Real_Time.Time_Span)
                      return System_Calls.Time_Span;

   --  Reads up to Room bytes of the input into Block. Length is negative when
   --  there is no input. A datagram may be empty, too.
   procedure Read_Block (Room : size_t; Length : out Byte_Total);

   function Limit_Of (Span : Ada.Real_Time.Time_Span)
                      return System_Calls.Time_Span
   is
      Nanosecs : Long_Long_Integer := 0;
   begin
      if Span > Ada.Real_Time.Time_Span_Zero then
         Nanosecs := Long_Long_Integer (To_Duration (Span) * 1.0E9);
      end if;
      return
        (Seconds     => long (Nanosecs / 1_000_000_000),
         Nanoseconds => long (Nanosecs mod 1_000_000_000));
   end Limit_Of;

   procedure Read_Block (Room : size_t; Length : out Byte_Total) is
   begin
      if Is_Serial then
         Length := Read (Line, Block'Address, Room);
         if Length = 0 then
            Length := Failed;
         end if;
         return;
      end if;

      --  An error is no character and does not end the input. A missing peer
      --  is such an error: the operating system then reports that a datagram
      --  was refused. An empty datagram does not end the input either.
      Length := Receive (Line, Block'Address, Room, Dont_Wait);
      if Length < 0 and then GNAT.OS_Lib.Errno /= Would_Block then
         Length := 0;
      end if;
   end Read_Block;

   procedure Wait (Until_Time : Time; Look_At_Line : Boolean := True) is
      Span     : constant Ada.Real_Time.Time_Span := Until_Time - Clock;
      Requests : Poll_Requests :=
        ((Wake_Events, Input_Ready, 0), (Line, Input_Ready, 0));
      Cleared  : Byte_Total;
      Found    : int;
   begin
      --  A line without another end would always be ready at once.
      Found := Poll
        (Requests'Address,
         (if Is_Hung_Up or else not Look_At_Line then 1 else 2),
         Limit_Of (Span), System.Null_Address);
      Is_Hung_Up :=
        not Is_Hung_Up
        and then Found > 0
        and then Has_Hung_Up (Requests (2));

      if Found > 0 and then Requests (1).Found = Input_Ready then
         Cleared := Read (Wake_Events, Block'Address, 8);
         pragma Unreferenced (Cleared);
      end if;
   end Wait;

   procedure Wake is
      One     : aliased constant Interfaces.Unsigned_64 := 1;
      Written : Byte_Total;
   begin
      Written := Write (Wake_Events, One'Address, 8);

      --  Without room it was nudged already.
      pragma Unreferenced (Written);
   end Wake;

   procedure Receive (Heard : in out Arrivals) is
      Room   : Character_Count;
      Length : Byte_Total;
   begin
      Heard.Length := 0;
      Heard.Reads := 0;
      Heard.Emptied := False;
      loop
         Room := Character_Index'Last - Heard.Length;
         exit when Room < Block_Length / 2
           or else Heard.Reads = Read_Count'Last;

         Read_Block (size_t (Room), Length);
         if Length < 0 then
            Heard.Emptied := True;
            exit;
         end if;
         Heard.Reads := Heard.Reads + 1;

         for Each of Block (1 .. Integer (Length)) loop
            if Is_Serial then
               declare
                  Found        : Boolean;
                  Parity_Error : Boolean;
               begin
                  Error_Marks.Take (Marks, Each, Found, Parity_Error);
                  if Found then
                     Heard.Length := Heard.Length + 1;
                     Heard.Items (Heard.Length) := (Each, Parity_Error);
                  end if;
               end;
            else
               Heard.Length := Heard.Length + 1;
               Heard.Items (Heard.Length) := (Each, False);
            end if;
         end loop;
      end loop;
   end Receive;

   procedure Throw_Away (Heard : in out Arrivals) is
   begin
      for Each in 1 .. Heard.Length loop
         Thrown := Incremented (Thrown);
      end loop;
      Heard.Length := 0;
   end Throw_Away;

   procedure Discard
     (Silence : Ada.Real_Time.Time_Span;
      At_Most : Ada.Real_Time.Time_Span)
   is
      Ends     : constant Time := Clock + At_Most;
      Requests : Poll_Requests := (1 => (Line, Input_Ready, 0));
      Length   : Byte_Total;
   begin
      loop
         --  In a flood it rests between reads.
         for Attempt in Read_Count loop
            if Attempt = Read_Count'Last then
               delay until Clock + Flood_Guards.Rest;
            end if;
            Read_Block (Block_Length, Length);
            exit when Length < 0;
            for Each in 1 .. Length loop
               Thrown := Incremented (Thrown);
            end loop;
         end loop;
         exit when Clock >= Ends
           or else Poll
             (Requests'Address, 1, Limit_Of (Silence),
              System.Null_Address) <= 0
           or else Has_Hung_Up (Requests (1));
      end loop;
      Error_Marks.Forget (Marks);
   end Discard;

   procedure Send (Characters : Character_Array) is
      Length : constant size_t := Characters'Length;
      Sent   : Byte_Total;
   begin
      for Attempt in 1 .. 2 loop
         if Is_Serial then
            Sent := Write (Line, Characters'Address, Length);
         else
            --  Without room the characters are lost: the board does not wait.
            Sent := Send
              (Line, Characters'Address, Length, No_Signal + Dont_Wait);
         end if;

         --  A socket first reports that an earlier datagram was refused.
         exit when Is_Serial or else Sent >= 0
           or else GNAT.OS_Lib.Errno = Would_Block;
      end loop;

      for Missing in Byte_Total'Max (Sent, 0) + 1 .. Byte_Total (Length) loop
         Lost := Incremented (Lost);
      end loop;
   end Send;

   function Not_Sent return Count is (Lost);

   function Discarded return Count is (Thrown);

end Partitions.Links;
