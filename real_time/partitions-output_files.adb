--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Latin_1;
with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;

with Host.Complaints;
with Host.Outputs;
with Host.Text_Numbers;
with Host.Text_Output;             use Host.Text_Output;
with Partitions.Notes;
with Partitions.Output_Buffers;    use Partitions.Output_Buffers;

package body Partitions.Output_Files is

   use type URVOS.Count;

   --  The outputs of Kept, and standard output.
   type Place is
     (Record_Place, Recording_Place, Summary_Place, Events_Place,
      Screen_Place);

   function Place_Of (Which : Kept) return Place is
     (case Which is
         when Record_Option    => Record_Place,
         when Recording_Option => Recording_Place,
         when Summary_Option   => Summary_Place,
         when others           => Events_Place);

   --  At the end an output that accepts no text for this time is lost.
   Longest_Wait : constant Time_Span := Seconds (3);
   Look         : constant Time_Span := Milliseconds (5);

   Files  : Host.Outputs.File_Set;
   Screen : Writer;

   Buffers      : array (Place) of Buffer;
   Data_Waiting : array (Place) of Suspension_Object;

   --  Outputs that accept no text at the end. Used by the environment task.
   Stuck : array (Place) of Boolean := (others => False);

   --  Rows that found no room.
   Left_Out : array (Growing) of URVOS.Count := (others => 0);

   --  Names of the requested outputs.
   Asked : Choices;

   --  Writes the buffered text to a file, until its end.
   procedure Write
     (This : in out Buffer; To : in out Writer; Is_Over : out Boolean);

   --  Waits for it.
   procedure Finish (Which : Place; Title : String);

   procedure Write
     (This : in out Buffer; To : in out Writer; Is_Over : out Boolean)
   is
      Text       : Block;
      Length     : Natural;
      Is_Version : Boolean;
   begin
      loop
         This.Take (Text, Length, Is_Version, Is_Over);
         exit when Length = 0;
         if Is_Version and then Can_Restart (To) then
            Restart (To);
         end if;
         Put (To, Text (1 .. Length));
         if Is_Version and then Can_Restart (To) then
            End_Version (To);
         else
            Flush (To);
         end if;
         This.Done;
      end loop;
   end Write;

   task type File_Writer (Which : Place);

   task body File_Writer is
      Is_Over : Boolean;
   begin
      loop
         Suspend_Until_True (Data_Waiting (Which));
         case Which is
            when Record_Place  =>
               Write (Buffers (Which), Files (Record_Option), Is_Over);
            when Recording_Place =>
               Write (Buffers (Which), Files (Recording_Option), Is_Over);
               Synchronise (Files (Recording_Option));
            when Summary_Place =>
               Write (Buffers (Which), Files (Summary_Option), Is_Over);
            when Events_Place  =>
               Write (Buffers (Which), Files (Events_Option), Is_Over);
            when Screen_Place  =>
               Write (Buffers (Which), Screen, Is_Over);
         end case;
         if Is_Over then
            Buffers (Which).Close;
         end if;
      end loop;
   end File_Writer;

   Record_Writer    : File_Writer (Record_Place);
   Recording_Writer : File_Writer (Recording_Place);
   Summary_Writer   : File_Writer (Summary_Place);
   Events_Writer    : File_Writer (Events_Place);
   Screen_Writer    : File_Writer (Screen_Place);
   pragma Unreferenced
     (Record_Writer, Recording_Writer, Summary_Writer, Events_Writer,
      Screen_Writer);

   procedure Open (Chosen : Choices) is
   begin
      Asked := Chosen;
      Host.Outputs.Open (Files, Chosen);
   end Open;

   function Is_Open (Which : Kept) return Boolean is
     (Is_Open (Files (Which)));

   function Can_Restart (Which : Kept) return Boolean is
     (Can_Restart (Files (Which)));

   procedure Put_Row (Text : String; Which : Growing := Record_Option) is
      Is_Taken : Boolean := False;
   begin
      if not Is_Lost (Files (Which)) then
         Buffers (Place_Of (Which)).Put (Text, Is_Taken);
      end if;
      if not Is_Taken then
         for Each of Text loop
            if Each = Ada.Characters.Latin_1.LF then
               Left_Out (Which) := URVOS.Incremented (Left_Out (Which));
            end if;
         end loop;
      end if;
   end Put_Row;

   function Has_Room (Which : Growing) return Boolean is
     (Buffers (Place_Of (Which)).Waiting <= Capacity - Block_Length);

   function Rows_Left_Out (Which : Growing) return URVOS.Count is
     (Left_Out (Which));

   procedure Write_Rows (Which : Growing := Record_Option) is
   begin
      Set_True (Data_Waiting (Place_Of (Which)));
   end Write_Rows;

   procedure Put_Version (Which : Kept; Text : String) is
   begin
      Buffers (Place_Of (Which)).Replace (Text);
      Set_True (Data_Waiting (Place_Of (Which)));
   end Put_Version;

   procedure Print (Text : String) is
      Unused_Is_Taken : Boolean;   --  the buffer is empty
   begin
      Attach_Screen (Screen);
      Buffers (Screen_Place).Put (Text, Unused_Is_Taken);
   end Print;

   procedure Finish (Which : Place; Title : String) is
      This     : Buffer renames Buffers (Which);
      Progress : Natural := This.Progress;
      Next     : Time := Clock;
      Limit    : Time := Next + Longest_Wait;
   begin
      This.Finish;
      Set_True (Data_Waiting (Which));
      while not This.Is_Closed and then Next < Limit loop
         Next := Next + Look;
         delay until Next;
         if This.Progress /= Progress then
            Progress := This.Progress;
            Limit := Next + Longest_Wait;
         end if;
      end loop;
      if not This.Is_Closed then
         Stuck (Which) := True;
         Notes.Print
           (Title & " takes nothing: "
            & Host.Text_Numbers.Image (Long_Long_Integer (This.Waiting))
            & " characters are not written");
      end if;
   end Finish;

   procedure Finish (Which : Kept) is
   begin
      if Is_Open (Files (Which)) then
         Finish
           (Place_Of (Which),
            Name (Which) & ": "
            & Host.Complaints.Quoted (Value (Asked, Which)));
         if not Stuck (Place_Of (Which)) then
            Close (Files (Which));
         end if;
      end if;
   end Finish;

   procedure Finish_Printing is
   begin
      Finish (Screen_Place, "standard output");
   end Finish_Printing;

   function Is_Lost (Which : Kept) return Boolean is
     (Is_Lost (Files (Which)) or else Stuck (Place_Of (Which)));

   function Any_Lost return Boolean is
     (Host.Text_Output.Any_Lost
      or else (for some Each of Left_Out => Each > 0)
      or else (for some Each of Stuck => Each));

end Partitions.Output_Files;
