--  SPDX-License-Identifier: Apache-2.0

--  Two telemetry boards and the line between them, in character times. A test
--  may spoil or add any character on the line. An added character is heard one
--  character time later, so one added to a message's last comes after its end.

with URVOS;            use URVOS;
with Telemetry;        use Telemetry;
with Telemetry.Boards; use Telemetry.Boards;

package Link_Rig is

   --  The character that arrives in place of the one sent.
   type Arrival is
     (Whole,
      Changed,      --  other bits, parity right
      Odd_Parity,   --  other bits, parity wrong
      Lost,
      Doubled);     --  the character, then it again, changed

   --  Decides the arrival of a sender's Number-th character, counted from 1.
   --  Mask gives the bits to change.
   type Fault_Procedure is access procedure
     (Sender : Station;
      Number : Positive;
      What   : out Arrival;
      Mask   : out Byte);

   type Character_Counts is array (Station) of Natural;

   --  Blocks carry marks from 1. The rig keeps the last mark given and the
   --  last one delivered, so that no older block may be delivered.
   type Last_Marks is array (Station) of Byte;

   --  The number of characters that a station sent in a row.
   type Transmission is record
      Sender : Station;
      Length : Natural;
   end record;

   --  The characters of a data message: header, data, checksum.
   Up_Data   : constant := Uplink_Length + 2;
   Down_Data : constant := Downlink_Length + 2;

   type Added_Character is record
      Is_There : Boolean := False;
      Data     : Byte    := 0;
   end record;
   type Added_Characters is array (Station) of Added_Character;

   --  A line slower than a wire: the characters under way, the next one first.
   --  Its delay is up to the room in the nodes' frame, or more.
   type Line_Time is range 0 .. 14;

   type Coming is record
      Is_There : Boolean  := False;
      Number   : Positive := 1;
      Data     : Byte     := 0;
   end record;
   type Coming_List is array (Line_Time) of Coming;
   type Ways is array (Station) of Coming_List;

   Longest_Trace : constant := 32;
   type Trace_List is array (1 .. Longest_Trace) of Transmission;

   type Link is record
      Ground_Board   : Board :=
        New_Board (Ground, Uplink_Length, Downlink_Length);
      Aircraft_Board : Board :=
        New_Board (Aircraft, Downlink_Length, Uplink_Length);
      Sent           : Character_Counts := (others => 0);
      Given          : Last_Marks := (others => 0);
      Came_Out       : Last_Marks := (others => 0);

      --  The characters that the line has added and the listener has not
      --  heard; each comes a character time after the one before.
      Added          : Added_Characters;

      --  The time of a character one way, in character times.
      One_Way        : Line_Time := 0;
      On_Its_Way     : Ways;

      --  The turns since the link was made, as far as there is room.
      Trace          : Trace_List;
      Turns          : Natural := 0;
   end record;

   --  The character times of the report's major frame (D-4). Frames of these
   --  tests have this length whatever the nodes' length, so a retry has room.
   Frame : constant := 20_000 / Microseconds_Per_Character;

   --  Dead space resets of both boards.
   function Resets (This : Link) return Count is
     (Tally (This.Ground_Board).Resets + Tally (This.Aircraft_Board).Resets);

   --  A link with this slow line. If Told is True, both boards know its delay.
   function Slow_Link (One_Way : Line_Time; Told : Boolean := True)
     return Link;

   --  Lets some character times pass.
   procedure Run
     (This  : in out Link;
      Times : Natural;
      Fault : Fault_Procedure := null);

   --  A station's controller gives its board a block.
   procedure Give (This : in out Link; From : Station; Mark : Byte);

   --  A station's controller takes the block that came in; Mark is 0 if there
   --  is none. The test fails if the block was never given, or is older than
   --  the one before.
   procedure Take (This : in out Link; At_Station : Station; Mark : out Byte);

   --  Flies frames in which both controllers give a block, the aircraft's
   --  Phase character times later, and take the received one at the frame's
   --  end. Marks begin with First.
   procedure Fly
     (This   : in out Link;
      Frames : Positive;
      First  : Byte;
      Phase  : Natural;
      Fault  : Fault_Procedure := null);

   --  Spoils a character about every third message; a single byte of checksum
   --  is meant for such errors. After Start_Rain the errors are the same.
   procedure Start_Rain;
   procedure Rain
     (Sender : Station;
      Number : Positive;
      What   : out Arrival;
      Mask   : out Byte);

   --  True for the cases that a test tries: all, but only each seventh where
   --  contracts are executed, for they take a hundred times as long.
   function Is_Tried (Case_Number : Natural) return Boolean;

end Link_Rig;
