--  SPDX-License-Identifier: Apache-2.0

--  The rows of the flight record on their way from the controller to the file:
--  the controller never waits for a disk.

with Host.Plant_Messages; use Host.Plant_Messages;
with Host.Text_Numbers;
with Partitions.Peer_Watch; use Partitions.Peer_Watch;
with URVOS; use URVOS;

package Partitions.Rows is

   subtype Number is Host.Text_Numbers.Number;

   Most_Columns : constant := 100;
   type Column is range 0 .. Most_Columns;
   type Values is array (Column range 1 .. Most_Columns) of Number;

   --  With an aircraft in JSBSim, its true state; and the state of the other
   --  node.
   type Row is record
      Length    : Column      := 0;
      Value     : Values      := (others => 0);
      Has_Truth : Boolean     := False;
      Truth     : Shown_State := (others => 0.0);
      Peer      : Peer_State  := Never_Heard;
   end record;

   procedure Append (To : in out Row; Value : Number)
     with Pre => To.Length < Most_Columns;

   Capacity : constant := 256;
   type Place is mod Capacity;
   type Row_Array is array (Place) of Row;

   --  Waits for the next row. Found is False when there is none left. For one
   --  task.
   procedure Await (Item : out Row; Found : out Boolean);

   protected Queue is

      --  A row that finds no room is left out.
      procedure Put (Item : Row);

      --  No more rows follow.
      procedure Finish;

      --  Found is False when there is none; Is_Over when none follows.
      procedure Take
        (Item    : out Row;
         Found   : out Boolean;
         Is_Over : out Boolean);

      function Left_Out return Count;

   private
      Rows    : Row_Array;
      First   : Place   := 0;
      Length  : Natural := 0;
      Done    : Boolean := False;
      Missing : Count   := 0;
   end Queue;

end Partitions.Rows;
