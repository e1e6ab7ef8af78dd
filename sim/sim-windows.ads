--  SPDX-License-Identifier: Apache-2.0

--  Spans of time, each from First until just before Stop, and a reader's
--  position, which only moves forward.

private with Ada.Containers.Vectors;

package Sim.Windows is

   type Window is record
      First : Microseconds;
      Stop  : Microseconds;
   end record;

   --  The span after the last one.
   Never : constant Window := (Microseconds'Last, Microseconds'Last);

   type List is private;

   --  Adds a span, in any order. Spans that touch or overlap become one. The
   --  reader must not have moved yet.
   procedure Add (To : in out List; Added : Window);

   --  The first span that is not over.
   function Next (From : List) return Window with Inline;

   --  Moves the reader past the next span.
   procedure Skip (Over : in out List);

private

   package Window_Vectors is new Ada.Containers.Vectors (Positive, Window);

   type List is record
      --  In order and disjoint.
      Windows : Window_Vectors.Vector;
      Index   : Positive := 1;
      Current : Window   := Never;
   end record;

   function Next (From : List) return Window is (From.Current);

end Sim.Windows;
