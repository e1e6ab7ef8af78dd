--  SPDX-License-Identifier: Apache-2.0

--  Two telemetry boards and the line between them, in character times. A
--  test may spoil any character on the line, or add one, which is heard a
--  character time after it: the last of a message comes after its end then.

with URVOS;            use URVOS;
with Telemetry;        use Telemetry;
with Telemetry.Boards; use Telemetry.Boards;

package Link_Rig is

   --  What arrives in place of a character that was sent.
   type Arrival is
     (Whole,
      Changed,      --  other bits, parity right
      Odd_Parity,   --  other bits, parity wrong
      Lost,
      Doubled);     --  the character, then it again, changed

   --  Decides what arrives of a sender's Number-th character, counted from
   --  1. The bits to change are in Mask.
   type Fault_Procedure is access procedure
     (Sender : Station;
      Number : Positive;
      What   : out Arrival;
      Mask   : out Byte);

   type Character_Counts is array (Station) of Natural;

   --  Blocks are known by a mark from 1. The last one that was given is kept,
   --  and the last one that came out at the other end, so that none may come
   --  out that is older.
   type Last_Marks is array (Station) of Byte;

   --  Who sent how many characters in a row.
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

   --  A line slower than a wire: what is on its way, the next one first. It
   --  is as slow as the nodes' frame leaves room for, or slower.
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

      --  What the line has added and each sender's listener is yet to hear:
      --  a character time later than the one before it.
      Added          : Added_Characters;

      --  How many character times a character takes, one way.
      One_Way        : Line_Time := 0;
      On_Its_Way     : Ways;

      --  The turns since the link was made, as many as there is room for.
      Trace          : Trace_List;
      Turns          : Natural := 0;
   end record;

   --  Character times of the report's major frame (D-4). A frame of these
   --  tests is as long whatever the nodes' is: a retry has room in it.
   Frame : constant := 20_000 / Microseconds_Per_Character;

   --  Dead space resets of both boards.
   function Resets (This : Link) return Count is
     (Tally (This.Ground_Board).Resets + Tally (This.Aircraft_Board).Resets);

   --  A link with so slow a line, of which both boards are told or not.
   function Slow_Link (One_Way : Line_Time; Told : Boolean := True)
     return Link;

   --  Lets some character times pass.
   procedure Run
     (This  : in out Link;
      Times : Natural;
      Fault : Fault_Procedure := null);

   --  A station's controller gives its board a block.
   procedure Give (This : in out Link; From : Station; Mark : Byte);

   --  A station's controller takes the block that came in; Mark is 0 if
   --  there is none. The test fails if the block is not one that was given,
   --  or older than the one before.
   procedure Take (This : in out Link; At_Station : Station; Mark : out Byte);

end Link_Rig;
