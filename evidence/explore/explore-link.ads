--  SPDX-License-Identifier: Apache-2.0

--  Both boards together, after the last fault.
--
--  Find_Quiet: from every pair of sides, whatever the controllers do, both
--  are quiet after a while. Find_Delivery: from there, with both controllers
--  giving a block once a frame, at every phase of either, a block given
--  after the last fault is received.

package Explore.Link is

   type Direction is (Uplink, Downlink);

   type Findings is record
      States      : Long_Long_Integer := 0;
      Transitions : Long_Long_Integer := 0;

      --  The longest way, in character times.
      Worst       : Natural := 0;

      --  No way goes round for ever.
      Ends_Always : Boolean := True;
   end record;

   --  Both controllers put blocks whenever they like, without limit.
   procedure Find_Quiet (Result : out Findings);

   --  The pairs of which both sides are quiet.
   function Calm_Pairs return Natural;

   procedure Find_Delivery (Way : Direction; Result : out Findings);

   --  The path of the last search that did not always end.
   procedure Print_Way;

end Explore.Link;
