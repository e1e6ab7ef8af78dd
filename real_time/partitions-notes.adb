--  SPDX-License-Identifier: Apache-2.0

with Ada.Command_Line;
with Ada.Directories;
with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with GNAT.OS_Lib;                  use GNAT.OS_Lib;

with Partitions.Output_Buffers;    use Partitions.Output_Buffers;

package body Partitions.Notes is

   Waiting       : Buffer;
   Lines_Waiting : Suspension_Object;

   task Printer;

   task body Printer is
      Text              : Block;
      Length            : Natural;
      Unused_Is_Version : Boolean;
      Unused_Is_Over    : Boolean;

      --  A failed write does not stop the partition.
      Unused_Written : Integer;
   begin
      loop
         Suspend_Until_True (Lines_Waiting);
         loop
            Waiting.Take
              (Text, Length, Unused_Is_Version, Unused_Is_Over);
            exit when Length = 0;
            Unused_Written := Write (Standerr, Text'Address, Length);
            Waiting.Done;
         end loop;
      end loop;
   end Printer;

   procedure Print (Message : String) is
   begin
      Print_Lines
        (Ada.Directories.Simple_Name (Ada.Command_Line.Command_Name) & ": "
         & Message & ASCII.LF);
   end Print;

   procedure Print_Lines (Text : String) is
      --  A million characters wait: the terminal has been gone for hours.
      Unused_Is_Taken : Boolean;
   begin
      Waiting.Put (Text, Unused_Is_Taken);
      Set_True (Lines_Waiting);
   end Print_Lines;

   procedure Finish is
      Look  : constant Time_Span := Milliseconds (5);
      Limit : constant Time := Clock + Seconds (2);
      Next  : Time := Clock;
   begin
      while Waiting.Waiting > 0 and then Clock < Limit loop
         Next := Next + Look;
         delay until Next;
      end loop;
   end Finish;

end Partitions.Notes;
