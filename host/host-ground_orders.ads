--  SPDX-License-Identifier: Apache-2.0

--  Orders of the ground's console besides the sticks, from a file (--orders):
--  blocks that are sent in place of a frame's commands (EXT-2).

with Ada.Containers.Vectors;

with URV.Type_Codes; use URV.Type_Codes;

package Host.Ground_Orders is

   --  An order replaces a frame's commands. Between two orders the aircraft
   --  must receive enough commands not to declare the link lost.
   Least_Between : constant Microseconds := 100_000;

   type Order_Kind is (Configure, Block);

   --  The form of such an order: "TIME_MS configure TABLE ORBIT_MS END_MS".
   function Form_Of (Kind : Order_Kind) return String;

   type Script is limited private;

   --  Reads and checks the file; refuses it at its first wrong line.
   procedure Load (Loaded : in out Script; File : String);

   --  A block is a test card, or another of its kind.
   function Has_Cards (From : Script) return Boolean;

   --  The time of the next order, Never after the last.
   function Next_Time (From : Script) return Microseconds;

   --  Takes the next order.
   procedure Advance (From : in out Script; Block : out Uplink_Buffer)
     with Pre => Next_Time (From) /= Never;

private

   type Order is record
      Time  : Microseconds;
      Block : Uplink_Buffer;
   end record;

   package Order_Vectors is new Ada.Containers.Vectors (Positive, Order);

   type Script is limited record
      Orders : Order_Vectors.Vector;
      Next   : Positive := 1;
   end record;

   function Has_Cards (From : Script) return Boolean is
     (for some Item of From.Orders =>
        Kind_Of (Item.Block) = Test_Card_Kind);

   function Next_Time (From : Script) return Microseconds is
     (if From.Next > From.Orders.Last_Index then Never
      else From.Orders (From.Next).Time);

end Host.Ground_Orders;
