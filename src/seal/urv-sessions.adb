--  SPDX-License-Identifier: Apache-2.0

package body URV.Sessions with SPARK_Mode is

   function Derived
     (From           : Key;
      For_Use        : Use_Of_Key;
      Ground_Nonce   : Nonce;
      Aircraft_Nonce : Nonce) return Key
   is
      function Ground_Byte (Where : Byte_Index) return Byte is
        (Byte_Of (Ground_Nonce, Where))
      with Pre => Where <= 8;

      function Aircraft_Byte (Where : Byte_Index) return Byte is
        (Byte_Of (Aircraft_Nonce, Where))
      with Pre => Where <= 8;

      --  The words of the two messages differ in the first half.

      function First_Half (Half : Byte) return Unsigned_32 is
        (Half_Of
           (Byte (Use_Of_Key'Pos (For_Use)), Half,
            Ground_Byte (1), Ground_Byte (2)));

      First_End : constant Unsigned_32 :=
        Half_Of
          (Ground_Byte (3), Ground_Byte (4), Ground_Byte (5),
           Ground_Byte (6));
      Second    : constant Unsigned_64 :=
        Joined
          (Half_Of
             (Ground_Byte (7), Ground_Byte (8), Aircraft_Byte (1),
              Aircraft_Byte (2)),
           Half_Of
             (Aircraft_Byte (3), Aircraft_Byte (4), Aircraft_Byte (5),
              Aircraft_Byte (6)));
      Third     : constant Unsigned_64 :=
        Joined
          (Half_Of (Aircraft_Byte (7), Aircraft_Byte (8), 0, 0),
           Half_Of (0, 0, 0, 18));

      function Half_Key (Half : Byte) return Unsigned_64
      with
        Post =>
          Half_Key'Result = Reference
            (Derivation (For_Use, Half, Ground_Nonce, Aircraft_Nonce), From);

      function Half_Key (Half : Byte) return Unsigned_64 is
         Hashed : constant Message :=
           Derivation (For_Use, Half, Ground_Nonce, Aircraft_Nonce)
         with Ghost;

         S : State := Initial (From);
      begin
         pragma Assert (Words_Of (Hashed) = 3);
         pragma Assert
           (Joined (First_Half (Half), First_End) = Word_At (Hashed, 0));
         Absorb (S, Joined (First_Half (Half), First_End));
         pragma Assert (S = After (Hashed, From, 1));
         pragma Assert (Padded (Hashed, 1, 0) = Ground_Byte (7));
         pragma Assert (Padded (Hashed, 1, 1) = Ground_Byte (8));
         pragma Assert
           (for all Where in Byte_Number range 2 .. 7 =>
              Padded (Hashed, 1, Where) =
                Aircraft_Byte (Byte_Index (Where) - 1));
         pragma Assert (Second = Word_At (Hashed, 1));
         Absorb (S, Second);
         pragma Assert (S = After (Hashed, From, 2));
         pragma Assert (Padded (Hashed, 2, 0) = Aircraft_Byte (7));
         pragma Assert (Padded (Hashed, 2, 1) = Aircraft_Byte (8));
         pragma Assert
           (for all Where in Byte_Number range 2 .. 6 =>
              Padded (Hashed, 2, Where) = 0);
         pragma Assert (Hashed.Length = 18);
         pragma Assert (Padded (Hashed, 2, 7) = 18);
         pragma Assert (Third = Word_At (Hashed, 2));
         Absorb (S, Third);
         pragma Assert (S = After (Hashed, From, 3));
         return Last_Tag (S);
      end Half_Key;

   begin
      return (K0 => Half_Key (0), K1 => Half_Key (1));
   end Derived;

end URV.Sessions;
