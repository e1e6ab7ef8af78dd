--  SPDX-License-Identifier: Apache-2.0

--  The lock that keeps a node's frames in step, shared by its clock and its
--  tasks (FRM-6). While it is off, each frame has the usual length.

with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frame_Locks;  use URVOS.Frame_Locks;
with URVOS.Frames;       use URVOS.Frames;

package URVOS.Shared_Frame_Locks with SPARK_Mode is

   protected type Lock is

      --  Before the node is switched on.
      procedure Set (On : Boolean);

      --  The node starts: see URVOS.Frame_Locks.Restarted.
      procedure Restart;

      --  See URVOS.Frame_Locks.

      procedure Tick (Available : Boolean);

      procedure Take (Fresh : Boolean; Now : Clock_Tick);

      function Request return Frame_Request;

      --  While it is not, it needs no ticks, and Request is No_Request.
      function Is_In_Use return Boolean;

      function Contents return Lock_State;

   private
      Is_On : Boolean := False;
      State : Lock_State;
   end Lock;

end URVOS.Shared_Frame_Locks;
