--  SPDX-License-Identifier: Apache-2.0

package body URV.Sip_Hash with SPARK_Mode is

   subtype Turn is Positive
   with Static_Predicate => Turn in 13 | 16 | 17 | 21;

   --  A rotation by 16 bits and a few more. The swapped halves exchange the
   --  bits that cross: a small processor swaps fast, and has no 64-bit shifts.
   function Turned (Item : Unsigned_64; Places : Turn) return Unsigned_64
   with
     Inline,
     Global => null,
     Post   => Turned'Result = Rotate_Left (Item, Places);

   procedure Mix (S : in out State)
   with
     Inline,
     Global => null,
     Post   => S = Round (S'Old);

   function Turned (Item : Unsigned_64; Places : Turn) return Unsigned_64 is
      Low      : constant Unsigned_32 :=
        Rotate_Left (Unsigned_32 (Item and 16#FFFF_FFFF#), 16);
      High     : constant Unsigned_32 :=
        Rotate_Left (Unsigned_32 (Shift_Right (Item, 32)), 16);
      Crossing : constant Unsigned_32 := (Low xor High)
        and (case Places is
                when 13     => 16#FFF8#,
                when 16     => 16#FFFF#,
                when 17     => 16#8000_FFFF#,
                when others => 16#F800_FFFF#);

      function Finished_Half (Half : Unsigned_32) return Unsigned_32 is
        (case Places is
            when 13     => Rotate_Right (Half xor Crossing, 3),
            when 16     => Half xor Crossing,
            when 17     => Rotate_Left (Half xor Crossing, 1),
            when others => Rotate_Left (Half xor Crossing, 5));

   begin
      return Joined (Low => Finished_Half (Low), High => Finished_Half (High));
   end Turned;

   procedure Mix (S : in out State) is
      Before : constant State := S with Ghost;
      Half   : State with Ghost;
   begin
      S.V0 := S.V0 + S.V1;
      S.V2 := S.V2 + S.V3;
      S.V1 := Turned (S.V1, 13) xor S.V0;
      S.V3 := Turned (S.V3, 16) xor S.V2;
      S.V0 := Rotate_Left (S.V0, 32);
      Half := S;
      pragma Assert (Half = Half_Round (Before, 13, 16));

      S.V2 := S.V2 + S.V1;
      S.V0 := S.V0 + S.V3;
      S.V1 := Turned (S.V1, 17) xor S.V2;
      S.V3 := Turned (S.V3, 21) xor S.V0;
      S.V2 := Rotate_Left (S.V2, 32);
      pragma Assert (S = Crossed (Half_Round (Crossed (Half), 17, 21)));
   end Mix;

   procedure Absorb (S : in out State; Data : Unsigned_64) is
      Before : constant State := S with Ghost;
      Copy   : State := S;
   begin
      Copy.V3 := Copy.V3 xor Data;
      Mix (Copy);
      Mix (Copy);
      Copy.V0 := Copy.V0 xor Data;
      pragma Assert (Copy = Absorbed (Before, Data));
      S := Copy;
   end Absorb;

   --  To absorb 0 is to mix twice.
   function Last_Tag (S : State) return Unsigned_64 is
      Last : State := S;
   begin
      Last.V2 := Last.V2 xor 16#FF#;
      Absorb (Last, 0);
      Absorb (Last, 0);
      pragma Assert (Last = Finished (S));
      return Folded (Last);
   end Last_Tag;

   function Tag (This : Message; With_Key : Key) return Unsigned_64 is
      S : State := Initial (With_Key);
   begin
      for Which in Word_Count range 0 .. Words_Of (This) - 1 loop
         Absorb (S, Word_At (This, Which));
         pragma Loop_Invariant (S = After (This, With_Key, Which + 1));
      end loop;
      return Last_Tag (S);
   end Tag;

end URV.Sip_Hash;
