--  SPDX-License-Identifier: Apache-2.0

--  SipHash-2-4 (Aumasson and Bernstein, 2012), a keyed hash of short messages.
--  It computes the tags of sealed blocks and derives session keys (SEC-2).
--
--  Round, Absorbed and Reference state the paper's definition as functions.
--  Initial, Absorb and Last_Tag are the implementation, proved equal to them.
--  Callers that have no Message absorb its words themselves.

with Interfaces; use Interfaces;
with URVOS;      use URVOS;

package URV.Sip_Hash with Pure, SPARK_Mode is

   --  The paper's k0 and k1: 16 bytes, the low byte of each half first.
   type Key is record
      K0 : Unsigned_64;
      K1 : Unsigned_64;
   end record;

   --  A message of up to 63 bytes. Bytes after Length have no effect.
   type Message_Length is range 0 .. 63;
   subtype Message_Index is Message_Length range 1 .. Message_Length'Last;
   type Octets is array (Message_Index) of Byte
   with Alignment => 2;

   type Message is record
      Length : Message_Length := 0;
      Bytes  : Octets         := (others => 0);
   end record
   with Alignment => 2;

   --  Halves of a word, the low byte first, and a word.

   function Half_Of (A, B, C, D : Byte) return Unsigned_32 is
     (Unsigned_32 (A)
      or Shift_Left (Unsigned_32 (B), 8)
      or Shift_Left (Unsigned_32 (C), 16)
      or Shift_Left (Unsigned_32 (D), 24))
   with Global => null;

   function Joined (Low, High : Unsigned_32) return Unsigned_64 is
     (Unsigned_64 (Low) or Shift_Left (Unsigned_64 (High), 32))
   with Global => null;

   --  The paper's words of 8 bytes: the message, zeros, and in the last byte
   --  of the last word the length.
   type Word_Count is range 0 .. 8;
   subtype Word_Number is Word_Count range 0 .. 7;
   subtype Byte_Number is Natural range 0 .. 7;

   function Words_Of (This : Message) return Word_Count is
     (Word_Count (This.Length / 8) + 1)
   with Global => null;

   function Padded
     (This  : Message;
      Which : Word_Number;
      Where : Byte_Number) return Byte
   is
     (if 8 * Natural (Which) + Where < Natural (This.Length)
      then This.Bytes (Message_Index (8 * Natural (Which) + Where + 1))
      elsif Which = Words_Of (This) - 1 and then Where = 7
      then Byte (This.Length)
      else 0)
   with Global => null;

   function Word_At
     (This  : Message;
      Which : Word_Number) return Unsigned_64
   is
     (Joined
        (Half_Of
           (Padded (This, Which, 0), Padded (This, Which, 1),
            Padded (This, Which, 2), Padded (This, Which, 3)),
         Half_Of
           (Padded (This, Which, 4), Padded (This, Which, 5),
            Padded (This, Which, 6), Padded (This, Which, 7))))
   with Global => null;

   --  The state, and a SipRound: two halves of the same shape.

   type State is record
      V0, V1, V2, V3 : Unsigned_64;
   end record;

   function Half_Round (S : State; Left, Right : Positive) return State is
     ((V0 => Rotate_Left (S.V0 + S.V1, 32),
       V1 => Rotate_Left (S.V1, Left) xor (S.V0 + S.V1),
       V2 => S.V2 + S.V3,
       V3 => Rotate_Left (S.V3, Right) xor (S.V2 + S.V3)))
   with
     Ghost,
     Global => null,
     Pre    => Left < 64 and then Right < 64;

   function Crossed (S : State) return State is
     ((V0 => S.V2, V1 => S.V1, V2 => S.V0, V3 => S.V3))
   with Ghost, Global => null;

   function Round (S : State) return State is
     (Crossed (Half_Round (Crossed (Half_Round (S, 13, 16)), 17, 21)))
   with Ghost, Global => null;

   --  From the key to the tag

   function Initial (With_Key : Key) return State is
     ((V0 => With_Key.K0 xor 16#736F6D6570736575#,
       V1 => With_Key.K1 xor 16#646F72616E646F6D#,
       V2 => With_Key.K0 xor 16#6C7967656E657261#,
       V3 => With_Key.K1 xor 16#7465646279746573#))
   with Global => null;

   --  Two rounds for each word.
   function Absorbed (S : State; Data : Unsigned_64) return State is
     ((Round (Round ((S with delta V3 => S.V3 xor Data)))
       with delta V0 =>
         Round (Round ((S with delta V3 => S.V3 xor Data))).V0 xor Data))
   with Ghost, Global => null;

   function After
     (This     : Message;
      With_Key : Key;
      Number   : Word_Count) return State
   is
     (if Number = 0 then Initial (With_Key)
      else Absorbed (After (This, With_Key, Number - 1),
                     Word_At (This, Number - 1)))
   with
     Ghost,
     Global             => null,
     Subprogram_Variant => (Decreases => Number);

   --  Four rounds at the end.
   function Finished (S : State) return State is
     (Round (Round (Round (Round ((S with delta V2 => S.V2 xor 16#FF#))))))
   with Ghost, Global => null;

   function Folded (S : State) return Unsigned_64 is
     (S.V0 xor S.V1 xor S.V2 xor S.V3)
   with Global => null;

   function Reference
     (This     : Message;
      With_Key : Key) return Unsigned_64
   is (Folded (Finished (After (This, With_Key, Words_Of (This)))))
   with Ghost, Global => null;

   --  Two rounds for a word, in place. In line everywhere they would lack
   --  registers.
   procedure Absorb (S : in out State; Data : Unsigned_64)
   with
     No_Inline,
     Global => null,
     Post   => S = Absorbed (S'Old, Data);

   --  The tag after the last word.
   function Last_Tag (S : State) return Unsigned_64
   with
     Global => null,
     Post   => Last_Tag'Result = Folded (Finished (S));

   function Tag (This : Message; With_Key : Key) return Unsigned_64
   with
     Global => null,
     Post   => Tag'Result = Reference (This, With_Key);

end URV.Sip_Hash;
