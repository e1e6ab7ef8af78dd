--  SPDX-License-Identifier: Apache-2.0

--  Text on its way to an output that may be slow. The writer never waits: a
--  text that finds no room is left out as a whole (RTP-10).
--
--  One task puts, another one takes, both of the default priority.

with System;

package Partitions.Output_Buffers is

   --  At least ten seconds of a record.
   Capacity : constant := 1_048_576;

   --  The most that is taken at once, and the longest version.
   Block_Length : constant := 65_536;
   subtype Block is String (1 .. Block_Length);

   protected type Buffer with Priority => System.Default_Priority is

      --  Is_Taken is False when there is no room for the whole text.
      procedure Put (Text : String; Is_Taken : out Boolean);

      --  Puts a version of the whole output, which replaces a version not
      --  taken yet. A text longer than a block is cut off.
      procedure Replace (Text : String);

      --  Ends the input.
      procedure Finish;

      --  Length is 0 when the buffer is empty; Is_Over when no more text
      --  follows. After the text is written, Done must be called.
      procedure Take
        (Text       : out Block;
         Length     : out Natural;
         Is_Version : out Boolean;
         Is_Over    : out Boolean);
      procedure Done;

      --  All has been written, and the output is closed.
      procedure Close;
      function Is_Closed return Boolean;

      --  Grows with each Done, and with Close.
      function Progress return Natural;

      --  The unwritten text, in characters.
      function Waiting return Natural;

   private
      Ring    : String (1 .. Capacity);
      First   : Positive := 1;
      Length  : Natural  := 0;
      Taken   : Natural  := 0;
      Version : Boolean  := False;
      Over    : Boolean  := False;
      Closed  : Boolean  := False;
      Steps   : Natural  := 0;
   end Buffer;

end Partitions.Output_Buffers;
