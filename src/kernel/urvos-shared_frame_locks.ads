--  SPDX-License-Identifier: Apache-2.0

--  What keeps a node's frames in step, for its clock and its tasks (FRM-6).
--  Unless it is switched on each frame lasts as long as ever.

with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frame_Locks;  use URVOS.Frame_Locks;
with URVOS.Frames;       use URVOS.Frames;

package URVOS.Shared_Frame_Locks with SPARK_Mode is

   protected type Lock is

      --  Before the node is switched on.
      procedure Set (On : Boolean);

      --  The node starts.
      procedure Begin_Anew;

      --  See URVOS.Frame_Locks.

      procedure Tick (Available : Boolean);

      procedure Take (Fresh : Boolean; Now : Clock_Tick);

      function Request return Frame_Request;

      function Contents return Lock_State;

   private
      Is_On : Boolean := False;
      State : Lock_State;
   end Lock;

end URVOS.Shared_Frame_Locks;
