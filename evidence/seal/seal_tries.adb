--  SPDX-License-Identifier: Apache-2.0

with Interfaces;       use Interfaces;
with Telemetry;        use Telemetry;
with URV.Plain_Blocks; use URV.Plain_Blocks;
with URV.Seal_Blocks;  use URV.Seal_Blocks;
with URV.Seals;        use URV.Seals;
with URV.Sessions;     use URV.Sessions;
with URVOS;            use URVOS;

package body Seal_Tries is

   --  SplitMix64.
   function Random return Unsigned_64;

   --  A frame passes, and a block of random words is closed.
   procedure Close_Next (From : Station; Block : out Block_Data);

   --  The other node opens it.
   procedure Exchange (From : Station; Block : out Block_Data);

   --  Both nodes are switched on again and have a session; its hellos are
   --  recorded.
   procedure Begin_Session (Keys : Key_List);

   --  Two blocks more each way, of which one is lost.
   procedure Go_On;

   function Tried (Kind : Attack; At_Node : Station) return Block_Data;

   State : Unsigned_64 := 0;

   function Random return Unsigned_64 is
      Mixed : Unsigned_64;
   begin
      State := State + 16#9E37_79B9_7F4A_7C15#;
      Mixed := State;
      Mixed := (Mixed xor Shift_Right (Mixed, 30)) * 16#BF58_476D_1CE4_E5B9#;
      Mixed := (Mixed xor Shift_Right (Mixed, 27)) * 16#94D0_49BB_1331_11EB#;
      return Mixed xor Shift_Right (Mixed, 31);
   end Random;

   function Below (Limit : Positive) return Natural is
     (Natural (Random mod Unsigned_64 (Limit)));

   type Link is array (Station) of Seal;

   Nodes : Link;

   --  A recorded session of the same nodes, of before.
   Longest : constant := 64;
   type Blocks is array (1 .. Longest, Station) of Block_Data;
   Recorded    : Blocks;
   Hellos      : Blocks;
   Hello_Count : Natural range 0 .. Longest := 0;

   --  The newest block each way, and one sent before it that got lost.
   Newest : array (Station) of Block_Data;
   Lost   : array (Station) of Block_Data;

   procedure Close_Next (From : Station; Block : out Block_Data) is
   begin
      for Node of Nodes loop
         Pass (Node, 1);
      end loop;
      Close
        (Nodes (From),
         [for Each in Word_Place => Word (Random and 16#0F0F#)], Block);
   end Close_Next;

   procedure Exchange (From : Station; Block : out Block_Data) is
      Unused_Words : Block_Words;
      Unused_What  : Outcome;
   begin
      Close_Next (From, Block);
      Open
        (Nodes (Other (From)), Block, True, Unused_Words, Unused_What);
   end Exchange;

   procedure Begin_Session (Keys : Key_List) is
      Block : Block_Data;
   begin
      Nodes :=
        (Ground   => New_Seal (Ground, 2, Keys, Nonce (Random)),
         Aircraft => New_Seal (Aircraft, 2, Keys, Nonce (Random)));
      Hello_Count := (if Hello_Count = Longest then 1 else Hello_Count + 1);
      Exchange (Ground, Block);
      Hellos (Hello_Count, Ground) := Block;
      Exchange (Aircraft, Block);
      Hellos (Hello_Count, Aircraft) := Block;
   end Begin_Session;

   procedure Go_On is
   begin
      for From in Station loop
         Close_Next (From, Lost (From));
         Exchange (From, Newest (From));
      end loop;
   end Go_On;

   function Tried (Kind : Attack; At_Node : Station) return Block_Data is
      Sender : constant Station := Other (At_Node);
      Length : constant Positive :=
        Positive (Covered (Sender) + Tag_Bytes (Sender));
      Result : Block_Data := Newest (Sender);
   begin
      case Kind is
         when Forged | Forged_Hello =>
            Result :=
              [for Each in Byte_Index => Byte (Random and 16#FF#)];
            Result (1) :=
              (if Kind = Forged_Hello then Hello_Mark
               else Sealed_Mark or (Result (1) and 16#0F#));
            if Kind = Forged_Hello then
               Result (2) := 1;
            end if;
         when Altered =>
            for Each in 1 .. 1 + Below (8) loop
               declare
                  Where : constant Byte_Index :=
                    Byte_Index (1 + Below (Length));
               begin
                  Result (Where) :=
                    Result (Where) xor Byte (2 ** Below (8));
               end;
            end loop;
            if Result = Newest (Sender) then
               Result (1) := Result (1) xor 1;
            end if;
         when Replayed =>
            null;
         when Reordered =>
            Result := Lost (Sender);
         when Other_Direction =>
            Result := Newest (At_Node);
         when Other_Session =>
            Result := Recorded (1 + Below (Longest), Sender);
         when Old_Hello =>
            Result := Hellos (1 + Below (Hello_Count), Sender);
         when Other_Format =>
            Result :=
              [for Each in Byte_Index => Byte (Random and 16#FF#)];
            Result (1) := Result (1) and 16#0F#;
      end case;
      return Result;
   end Tried;

   procedure Try (Number : Total; Seed : Total; Found : out Results) is
      Keys : constant Key_List :=
        (First  => (True, 1, (K0 => Random, K1 => Random)),
         Second => (others => <>));
      Tries_Of_A_Session : constant := 1_000;

      Kind  : Attack := Attack'First;
      Block : Block_Data;
      Words : Block_Words;
      What  : Outcome;
   begin
      State := Unsigned_64 (Seed);
      Found := (others => (others => 0));
      for Which in 1 .. Number loop
         if Which mod Tries_Of_A_Session = 1 then
            Begin_Session (Keys);
            for Each in 1 .. Longest loop
               Exchange (Ground, Recorded (Each, Ground));
               Exchange (Aircraft, Recorded (Each, Aircraft));
            end loop;
            Begin_Session (Keys);
            Exchange (Ground, Block);
            Exchange (Aircraft, Block);
         end if;

         Go_On;
         for At_Node in Station loop
            if At_Node = Station'Val (Which mod 2) then
               Block := Tried (Kind, At_Node);
               Open (Nodes (At_Node), Block, True, Words, What);
               if (for some Each of Words => Each /= 0) then
                  What := Opened;
               end if;
               Found (Kind, What) := Found (Kind, What) + 1;
            end if;
         end loop;
         Kind :=
           (if Kind = Attack'Last then Attack'First else Attack'Succ (Kind));
      end loop;
   end Try;

end Seal_Tries;
