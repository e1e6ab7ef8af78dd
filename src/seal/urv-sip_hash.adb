--  SPDX-License-Identifier: Apache-2.0

package body URV.Sip_Hash with SPARK_Mode is

   --  One procedure for all rounds: in line they would lack registers on a
   --  small processor.
   procedure Mix (S : in out State)
   with
     No_Inline,
     Global => null,
     Post   => S = Round (S'Old);

   procedure Mix (S : in out State) is
      Before : constant State := S with Ghost;
      Half   : State with Ghost;
   begin
      S.V0 := S.V0 + S.V1;
      S.V2 := S.V2 + S.V3;
      S.V1 := Rotate_Left (S.V1, 13) xor S.V0;
      S.V3 := Rotate_Left (S.V3, 16) xor S.V2;
      S.V0 := Rotate_Left (S.V0, 32);
      Half := S;
      pragma Assert (Half = Half_Round (Before, 13, 16));

      S.V2 := S.V2 + S.V1;
      S.V0 := S.V0 + S.V3;
      S.V1 := Rotate_Left (S.V1, 17) xor S.V2;
      S.V3 := Rotate_Left (S.V3, 21) xor S.V0;
      S.V2 := Rotate_Left (S.V2, 32);
      pragma Assert (S = Crossed (Half_Round (Crossed (Half), 17, 21)));
   end Mix;

   --  A word that the message fills.
   function Whole_Word (This : Message; Which : Word_Number)
                        return Unsigned_64
   with
     Global => null,
     Pre    => 8 * Natural (Which) + 8 <= Natural (This.Length),
     Post   => Whole_Word'Result = Word_At (This, Which);

   function Whole_Word (This : Message; Which : Word_Number)
                        return Unsigned_64
   is
      First : constant Message_Length := 8 * Message_Length (Which);

      function Half (Before : Message_Length) return Unsigned_32 is
        (Unsigned_32 (This.Bytes (Before + 1))
         or Shift_Left (Unsigned_32 (This.Bytes (Before + 2)), 8)
         or Shift_Left (Unsigned_32 (This.Bytes (Before + 3)), 16)
         or Shift_Left (Unsigned_32 (This.Bytes (Before + 4)), 24))
      with Pre => Before <= Message_Length'Last - 4;

   begin
      return Unsigned_64 (Half (First))
        or Shift_Left (Unsigned_64 (Half (First + 4)), 32);
   end Whole_Word;

   function Tag (This : Message; With_Key : Key) return Unsigned_64 is
      S    : State := Initial (With_Key);
      Data : Unsigned_64;

      Before : State with Ghost;
   begin
      for Which in Word_Count range 0 .. Words_Of (This) - 1 loop
         Before := S;
         Data :=
           (if 8 * Natural (Which) + 8 <= Natural (This.Length)
            then Whole_Word (This, Which) else Word_At (This, Which));
         S.V3 := S.V3 xor Data;
         Mix (S);
         Mix (S);
         S.V0 := S.V0 xor Data;
         pragma Assert (S = Absorbed (Before, Data));
         pragma Loop_Invariant (S = After (This, With_Key, Which + 1));
      end loop;

      Before := S;
      S.V2 := S.V2 xor 16#FF#;
      Mix (S);
      Mix (S);
      Mix (S);
      Mix (S);
      pragma Assert (S = Finished (Before));
      pragma Assert
        (S = Finished (After (This, With_Key, Words_Of (This))));
      pragma Assert
        (Reference (This, With_Key)
           = Folded (Finished (After (This, With_Key, Words_Of (This)))));
      return Folded (S);
   end Tag;

end URV.Sip_Hash;
