--  SPDX-License-Identifier: Apache-2.0

with GNAT.OS_Lib;
with Interfaces.C; use Interfaces.C;
with System;       use System;
with System.Address_To_Access_Conversions;

with Host.Complaints;         use Host.Complaints;
with Host.Text_Numbers;
with Partitions.System_Calls; use Partitions.System_Calls;

package body Partitions.Sockets is

   package Addresses is new
     System.Address_To_Access_Conversions (Address_Info);

   UDP_Prefix : constant String := "udp:";

   --  Refuses the option with the reason that the operating system gives.
   --  Given is the option and its value, for people.
   procedure Refuse_Socket (Given : String; Problem : String) with No_Return;

   --  The option and its value, for people.
   function Asked_For (Option, Place : String) return String is
     (Option & ": " & Quoted (Place));

   --  Removes the next part of the places.
   procedure Take_Part
     (Places : String;
      Next   : in out Positive;
      First  : out Positive;
      Last   : out Natural;
      Whole  : in out Boolean);

   --  The port is a number from 1 on.
   function Is_Port (Text : String) return Boolean;

   --  Asks the system for the addresses of a host.
   procedure Look_Up
     (Given : String;
      Host        : String;
      Port        : String;
      Local       : Boolean;
      Family      : int;
      Found       : out Address);

   --  The address of udp:HOST:PORT.
   procedure Look_Up_Place
     (Option : String;
      Place  : String;
      Local  : Boolean;
      Found  : out Address);

   function Is_Loopback (There : Address_Info) return Boolean;

   --  Makes a socket of a family of addresses, binds and connects it. Each
   --  refuses a failure.
   function Made_For (Given : String; Family : int) return File;
   procedure Bind_To (Given : String; Made : File; Here : Address_Info);
   procedure Connect_To
     (Given : String; Made : File; There : Address_Info; Failure : String);

   procedure Refuse_Socket (Given : String; Problem : String) is
      Reason : constant String := GNAT.OS_Lib.Errno_Message;
   begin
      Refuse (Given & Problem & ": " & Reason);
   end Refuse_Socket;

   procedure Take_Part
     (Places : String;
      Next   : in out Positive;
      First  : out Positive;
      Last   : out Natural;
      Whole  : in out Boolean)
   is
      In_Brackets : constant Boolean :=
        Next <= Places'Last and then Places (Next) = '[';
   begin
      First := (if In_Brackets then Next + 1 else Next);
      Last := First - 1;
      while Last < Places'Last
        and then Places (Last + 1) /= (if In_Brackets then ']' else ':')
      loop
         Last := Last + 1;
      end loop;
      Next := Last + (if In_Brackets then 2 else 1);

      --  Each part must be non-empty and followed by one colon, except the
      --  last.
      Whole := Whole and then Last >= First
        and then (Next > Places'Last or else Places (Next) = ':');
      Next := Next + 1;
   end Take_Part;

   function Is_Port (Text : String) return Boolean is
      Value    : Host.Text_Numbers.Number;
      Is_Valid : Boolean;
   begin
      Host.Text_Numbers.Read_Whole (Text, Value, Is_Valid);
      return Is_Valid and then Value in 1 .. 65_535;
   end Is_Port;

   procedure Look_Up
     (Given : String;
      Host        : String;
      Port        : String;
      Local       : Boolean;
      Family      : int;
      Found       : out Address)
   is
      Hints : constant Address_Info :=
        (Flags  => (if Local then To_Listen else 0),
         Family => Family,
         others => <>);
   begin
      if Get_Address (To_C (Host), To_C (Port), Hints, Found) /= 0 then
         Refuse (Given & ": there is no host " & Quoted (Host));
      end if;
   end Look_Up;

   function Made_For (Given : String; Family : int) return File is
      Made : constant File := Socket (Family, Datagram + Close_On_Exec, 0);
   begin
      if Made = Invalid then
         Refuse_Socket (Given, " cannot be opened");
      end if;
      return Made;
   end Made_For;

   procedure Bind_To (Given : String; Made : File; Here : Address_Info) is
   begin
      if Bind (Made, Here.Where, Here.Length) /= 0 then
         Refuse_Socket (Given, " cannot be bound to its port");
      end if;
   end Bind_To;

   procedure Connect_To
     (Given : String; Made : File; There : Address_Info; Failure : String) is
   begin
      if Connect (Made, There.Where, There.Length) /= 0 then
         Refuse_Socket (Given, Failure);
      end if;
   end Connect_To;

   function Opened (Places : String) return File is
      type Part is (Host, Port, Peer_Host, Peer_Port);
      type Bounds is array (Part) of Natural;

      Next  : Positive := Places'First;
      First : Bounds   := (others => 1);
      Last  : Bounds   := (others => 0);
      Whole : Boolean  := True;

      Given : constant String := Asked_For ("--link", UDP_Prefix & Places);
      Own         : Address;
      Peer        : Address;
      Made        : File;

      function Text (Which : Part) return String is
        (Places (First (Which) .. Last (Which)));
   begin
      for Which in Part loop
         Take_Part (Places, Next, First (Which), Last (Which), Whole);
      end loop;
      if not Whole or else Next <= Places'Last + 1 then
         Refuse (Given & " is not udp:HOST:PORT:PEER_HOST:PEER_PORT");
      end if;
      for Which in Part loop
         if Which in Port | Peer_Port and then not Is_Port (Text (Which)) then
            Refuse
              (Given & ": " & Quoted (Text (Which))
               & " is not a port from 1 to 65535");
         end if;
      end loop;

      Look_Up
        (Given, Text (Peer_Host), Text (Peer_Port), False, Any_Family, Peer);
      declare
         There : Address_Info renames Addresses.To_Pointer (Peer).all;
      begin
         Look_Up
           (Given, Text (Host), Text (Port), True, There.Family, Own);
         declare
            Here : Address_Info renames Addresses.To_Pointer (Own).all;
         begin
            Made := Made_For (Given, There.Family);
            Bind_To (Given, Made, Here);
            Connect_To (Given, Made, There, " cannot reach its peer");
         end;
      end;
      Free_Address (Own);
      Free_Address (Peer);
      return Made;
   end Opened;

   procedure Look_Up_Place
     (Option : String;
      Place  : String;
      Local  : Boolean;
      Found  : out Address)
   is
      Given : constant String := Asked_For (Option, Place);
      Next        : Positive := Place'First + UDP_Prefix'Length;
      Host_First  : Positive;
      Port_First  : Positive;
      Host_Last   : Natural;
      Port_Last   : Natural;
      Whole       : Boolean :=
        Place'Length > UDP_Prefix'Length
        and then Place (Place'First .. Next - 1) = UDP_Prefix;
   begin
      if Whole then
         Take_Part (Place, Next, Host_First, Host_Last, Whole);
         Take_Part (Place, Next, Port_First, Port_Last, Whole);
      end if;
      if not Whole or else Next <= Place'Last + 1 then
         Refuse (Given & " is not udp:HOST:PORT");
      elsif not Is_Port (Place (Port_First .. Port_Last)) then
         Refuse
           (Given & ": " & Quoted (Place (Port_First .. Port_Last))
            & " is not a port from 1 to 65535");
      end if;
      Look_Up
        (Given, Place (Host_First .. Host_Last),
         Place (Port_First .. Port_Last), Local, Any_Family, Found);
   end Look_Up_Place;

   function Sender (Option, Place : String) return File is
      Given : constant String := Asked_For (Option, Place);
      Found       : Address;
      Made        : File;
   begin
      Look_Up_Place (Option, Place, False, Found);
      declare
         There : Address_Info renames Addresses.To_Pointer (Found).all;
      begin
         Made := Made_For (Given, There.Family);
         Connect_To (Given, Made, There, " cannot be reached");
      end;
      Free_Address (Found);
      return Made;
   end Sender;

   function Is_Loopback (There : Address_Info) return Boolean is
      --  struct sockaddr_in, sockaddr_in6: family and port; in the second also
      --  four bytes of flow; the address.
      First_4 : constant := 5;
      First_6 : constant := 9;

      Bytes : Address_Bytes (1 .. Positive (There.Length))
        with Import, Convention => C, Address => There.Where;
   begin
      return
        (There.Family = Internet_4 and then Bytes (First_4) = 127)
        or else
        (There.Family = Internet_6
         and then Bytes (First_6 .. First_6 + 14)
                  = Address_Bytes'(1 .. 15 => 0)
         and then Bytes (First_6 + 15) = 1);
   end Is_Loopback;

   function Loopback_Receiver (Option, Place : String) return File is
      Given : constant String := Asked_For (Option, Place);
      Found       : Address;
      Made        : File;
   begin
      Look_Up_Place (Option, Place, True, Found);
      declare
         Here : Address_Info renames Addresses.To_Pointer (Found).all;
      begin
         if not Is_Loopback (Here) then
            Refuse
              (Given & " is not a loopback of this machine: 127.0.0.1, [::1]");
         end if;
         Made := Made_For (Given, Here.Family);
         Bind_To (Given, Made, Here);
      end;
      Free_Address (Found);
      return Made;
   end Loopback_Receiver;

end Partitions.Sockets;
