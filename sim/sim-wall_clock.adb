--  SPDX-License-Identifier: Apache-2.0

with Interfaces.C; use Interfaces.C;
with System;

package body Sim.Wall_Clock is

   --  The operating system: Linux, with words of 64 bits.

   Monotonic : constant := 1;
   Absolute  : constant := 1;

   Nanoseconds_A_Second : constant := 1_000_000_000;

   type Time_Spec is record
      Seconds     : long := 0;
      Nanoseconds : long := 0;
   end record with Convention => C;

   function Read_Clock (Clock : int; Result : out Time_Spec) return int
   with Import, Convention => C, External_Name => "clock_gettime";

   function Sleep
     (Clock  : int;
      Flags  : int;
      Wanted : Time_Spec;
      Rest   : System.Address) return int
   with Import, Convention => C, External_Name => "clock_nanosleep";

   --  A unit of Duration.
   pragma Compile_Time_Error
     (Duration'Small /= 1.0E-9, "a duration is not in nanoseconds");

   function Now return Duration is
      Read   : Time_Spec;
      Unused : constant int := Read_Clock (Monotonic, Read);
   begin
      return
        Duration (Read.Seconds) + Duration'Small * Integer (Read.Nanoseconds);
   end Now;

   procedure Wait (Until_Time : Duration) is
      Whole  : constant Long_Long_Integer :=
        Long_Long_Integer (Until_Time * 1.0E9);
      Unused : int;
   begin
      Unused :=
        Sleep
          (Monotonic, Absolute,
           (Seconds     => long (Whole / Nanoseconds_A_Second),
            Nanoseconds => long (Whole mod Nanoseconds_A_Second)),
           System.Null_Address);
   end Wait;

end Sim.Wall_Clock;
