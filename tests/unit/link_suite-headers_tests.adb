--  SPDX-License-Identifier: Apache-2.0

with AUnit.Assertions; use AUnit.Assertions;

with Checks;            use Checks;
with Expect_Value;
with Expectations;      use Expectations;
with URVOS;             use URVOS;
with Telemetry;         use Telemetry;
with Telemetry.Headers; use Telemetry.Headers;

separate (Link_Suite)
package body Headers_Tests is

   --  The tests, in order.
   procedure Round_Trips;
   procedure Valid_Bytes;
   procedure Distances;
   procedure Noise;

   type Row is record
      Value : Header;
      Name  : String (1 .. 16);
   end record;

   --  Every possible message.
   Table : constant array (Positive range <>) of Row :=
     (((Kind => Command_To_Downlink),         "command         "),
      ((Status, Good => True,  Wants_Downlink => False), "good            "),
      ((Status, Good => True,  Wants_Downlink => True),  "good, wants     "),
      ((Status, Good => False, Wants_Downlink => False), "bad             "),
      ((Status, Good => False, Wants_Downlink => True),  "bad, wants      "),
      ((Data, Length => 1),                   "data 1          "),
      ((Data, Length => 2),                   "data 2          "),
      ((Data, Length => 4),                   "data 4          "),
      ((Data, Length => Uplink_Length),       "data of uplink  "),
      ((Data, Length => Downlink_Length),     "data of downlink"));

   --  The number of ones in a byte.
   function Ones (Value : Byte) return Natural;

   procedure Expect is new Expect_Value (Header_Kind);

   function Ones (Value : Byte) return Natural is
     (if Value = 0 then 0
      else Natural (Value mod 2) + Ones (Value / 2));

   procedure Round_Trips is
   begin
      for Each of Table loop
         Expect (Each.Name & "is valid", Is_Valid (Encode (Each.Value)), True);
         Expect
           (Each.Name & "comes back as its kind",
            Decode (Encode (Each.Value)).Kind, Each.Value.Kind);
         Assert
           (Decode (Encode (Each.Value)) = Each.Value,
            Each.Name & "comes back as something else, expected itself");
      end loop;
   end Round_Trips;

   procedure Valid_Bytes is
      Valid : Natural := 0;
   begin
      for Value in Byte loop
         if Is_Valid (Value) then
            Valid := Valid + 1;
            Expect
              ("byte decoded and encoded", Encode (Decode (Value)), Value);
         end if;
      end loop;
      Expect_Number ("valid headers", Valid, Table'Length);
   end Valid_Bytes;

   procedure Distances is
   begin
      for One in Byte loop
         for Another in Byte loop
            if One /= Another
              and then Is_Valid (One) and then Is_Valid (Another)
            then
               Expect
                 ("less than 4 bits between" & One'Image & " and"
                  & Another'Image, Ones (One xor Another) < 4, False);
            end if;
         end loop;
      end loop;
   end Distances;

   procedure Noise is
   begin
      Expect ("a line held low is a header", Is_Valid (16#00#), False);
      Expect ("a line held high is a header", Is_Valid (16#FF#), False);
   end Noise;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "LNK-3 every kind of message comes back as it was sent",
         Round_Trips'Access);
      Add
        (Suite, "LNK-3 no byte but those of the ten messages is a header",
         Valid_Bytes'Access);
      Add
        (Suite, "D-6 three wrong bits never turn one header into another",
         Distances'Access);
      Add (Suite, "D-6 a dead line is no header", Noise'Access);
   end Add_To;

end Headers_Tests;
