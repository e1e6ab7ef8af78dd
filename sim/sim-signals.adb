--  SPDX-License-Identifier: Apache-2.0

with Interfaces.C; use Interfaces.C;
with System;       use System;
with System.Storage_Elements;

package body Sim.Signals is

   Keyboard_Interrupt : constant int := 2;
   Request_To_End     : constant int := 15;

   Default : constant Address := Null_Address;
   Ignored : constant Address := Storage_Elements.To_Address (1);

   type Times is range 0 .. 2;

   Came : array (Keyboard_Interrupt .. Request_To_End) of Times :=
     (others => 0) with Volatile_Components;

   --  Returns the previous handler. An interrupted read or write continues
   --  after the signal.
   function Set (Signal : int; To : Address) return Address
     with Import, Convention => C, External_Name => "signal";

   --  From Hold to Release a signal waits, even an ignored one.
   function Hold (Signal : int) return int
     with Import, Convention => C, External_Name => "sighold";
   function Release (Signal : int) return int
     with Import, Convention => C, External_Name => "sigrelse";

   procedure Remember (Signal : int) with Convention => C;

   procedure Watch (Signal : int);

   function Interrupted return Boolean is
     (Came (Keyboard_Interrupt) > 0 or else Came (Request_To_End) > 0);

   --  The previous handler.
   Set_Aside : Address := Default;

   procedure Begin_Deafness is
      Unused : constant int := Hold (Keyboard_Interrupt);
   begin
      Set_Aside := Set (Keyboard_Interrupt, Ignored);
   end Begin_Deafness;

   procedure End_Deafness is
      Before : constant Address := Set (Keyboard_Interrupt, Set_Aside);
      Unused : constant int     := Release (Keyboard_Interrupt);
      pragma Unreferenced (Before);
   begin
      null;
   end End_Deafness;

   procedure Remember (Signal : int) is
      Before : Address;
      pragma Unreferenced (Before);
   begin
      if Came (Signal) = 0 then
         Came (Signal) := 1;
      else
         Came (Signal) := 2;
         Before := Set (Signal, Default);
      end if;
   end Remember;

   procedure Watch (Signal : int) is
      Before : Address := Set (Signal, Remember'Address);
   begin
      if Before = Ignored then
         Before := Set (Signal, Ignored);
      end if;
   end Watch;

   procedure Watch is
   begin
      Watch (Keyboard_Interrupt);
      Watch (Request_To_End);
   end Watch;

end Sim.Signals;
