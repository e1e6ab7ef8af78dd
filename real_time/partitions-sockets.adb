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

   --  Refuses the link with the reason that the operating system gives.
   procedure Refuse_Link (Places : String; What : String) with No_Return;

   --  Takes the next part of the places off.
   procedure Take_Part
     (Places : String;
      Next   : in out Positive;
      First  : out Positive;
      Last   : out Natural;
      Whole  : in out Boolean);

   --  The port is a number from 1 on.
   function Is_Port (Text : String) return Boolean;

   --  Calls for the addresses of a host.
   procedure Look_Up
     (Places : String;
      Host   : String;
      Port   : String;
      Local  : Boolean;
      Family : int;
      Found  : out Address);

   procedure Refuse_Link (Places : String; What : String) is
      Reason : constant String := GNAT.OS_Lib.Errno_Message;
   begin
      Refuse ("--link: " & Quoted ("udp:" & Places) & What & ": " & Reason);
   end Refuse_Link;

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

      --  A part has something in it. One colon follows, or it is the last.
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
     (Places : String;
      Host   : String;
      Port   : String;
      Local  : Boolean;
      Family : int;
      Found  : out Address)
   is
      Hints : constant Address_Info :=
        (Flags  => (if Local then To_Listen else 0),
         Family => Family,
         others => <>);
   begin
      if Get_Address (To_C (Host), To_C (Port), Hints, Found) /= 0 then
         Refuse
           ("--link: " & Quoted ("udp:" & Places) & ": there is no host "
            & Quoted (Host));
      end if;
   end Look_Up;

   function Opened (Places : String) return File is
      type Part is (Host, Port, Peer_Host, Peer_Port);
      type Bounds is array (Part) of Natural;

      Next  : Positive := Places'First;
      First : Bounds   := (others => 1);
      Last  : Bounds   := (others => 0);
      Whole : Boolean  := True;

      Own   : Address;
      Peer  : Address;
      Made  : File;

      function Text (Which : Part) return String is
        (Places (First (Which) .. Last (Which)));
   begin
      for Which in Part loop
         Take_Part (Places, Next, First (Which), Last (Which), Whole);
      end loop;
      if not Whole or else Next <= Places'Last + 1 then
         Refuse
           ("--link: " & Quoted ("udp:" & Places)
            & " is not udp:HOST:PORT:PEER_HOST:PEER_PORT");
      end if;
      for Which in Part loop
         if Which in Port | Peer_Port and then not Is_Port (Text (Which)) then
            Refuse
              ("--link: " & Quoted ("udp:" & Places) & ": "
               & Quoted (Text (Which)) & " is not a port from 1 to 65535");
         end if;
      end loop;

      Look_Up
        (Places, Text (Peer_Host), Text (Peer_Port), False, Any_Family, Peer);
      declare
         There : Address_Info renames Addresses.To_Pointer (Peer).all;
      begin
         Look_Up
           (Places, Text (Host), Text (Port), True, There.Family, Own);
         declare
            Here : Address_Info renames Addresses.To_Pointer (Own).all;
         begin
            Made := Socket (There.Family, Datagram, 0);
            if Made = Invalid then
               Refuse_Link (Places, " cannot be opened");
            elsif Bind (Made, Here.Where, Here.Length) /= 0 then
               Refuse_Link (Places, " cannot be bound to its port");
            elsif Connect (Made, There.Where, There.Length) /= 0 then
               Refuse_Link (Places, " cannot reach its peer");
            end if;
         end;
      end;
      Free_Address (Own);
      Free_Address (Peer);
      return Made;
   end Opened;

end Partitions.Sockets;
