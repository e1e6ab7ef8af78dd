--  SPDX-License-Identifier: Apache-2.0

--  Spans of time, each from First until just before Stop, and the place in
--  them that somebody who only goes forward has come to.

private with Ada.Containers.Vectors;

package Sim.Windows is

   type Window is record
      First : Microseconds;
      Stop  : Microseconds;
   end record;

   --  What comes after the last one.
   Never : constant Window := (Microseconds'Last, Microseconds'Last);

   type List is private;

   --  Adds a span, in any order. Those that touch or overlap become one.
   --  Nobody may have gone forward yet.
   procedure Add (To : in out List; Added : Window);

   --  The first span that is not over.
   function Next (From : List) return Window with Inline;

   --  Goes on to the span after the next one.
   procedure Skip (Over : in out List);

private

   package Window_Vectors is new Ada.Containers.Vectors (Positive, Window);

   type List is record
      --  In order and apart from each other.
      Windows : Window_Vectors.Vector;
      Index   : Positive := 1;
      Current : Window   := Never;
   end record;

   function Next (From : List) return Window is (From.Current);

end Sim.Windows;
