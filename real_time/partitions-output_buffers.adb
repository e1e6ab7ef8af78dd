--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Output_Buffers is

   protected body Buffer is

      procedure Put (Text : String; Is_Taken : out Boolean) is
         Next  : Positive;
         Ahead : Natural;
      begin
         Is_Taken := Text'Length <= Capacity - Length;
         if Is_Taken then
            Next := (First + Length - 1) mod Capacity + 1;
            Ahead := Natural'Min (Text'Length, Capacity - Next + 1);
            Ring (Next .. Next + Ahead - 1) :=
              Text (Text'First .. Text'First + Ahead - 1);
            Ring (1 .. Text'Length - Ahead) :=
              Text (Text'First + Ahead .. Text'Last);
            Length := Length + Text'Length;
         end if;
      end Put;

      procedure Replace (Text : String) is
      begin
         First := 1;
         Length := Natural'Min (Text'Length, Block_Length);
         Ring (1 .. Length) := Text (Text'First .. Text'First + Length - 1);
         Version := True;
      end Replace;

      procedure Finish is
      begin
         Over := True;
      end Finish;

      procedure Take
        (Text       : out Block;
         Length     : out Natural;
         Is_Version : out Boolean;
         Is_Over    : out Boolean)
      is
         --  A text that wraps around is taken in two parts.
         Most : constant Natural :=
           Natural'Min (Block_Length, Capacity - First + 1);
      begin
         Length := Natural'Min (Buffer.Length, Most);
         Text (1 .. Length) := Ring (First .. First + Length - 1);
         Buffer.Length := Buffer.Length - Length;
         First := (First + Length - 1) mod Capacity + 1;
         Taken := Length;
         Is_Version := Version;
         Is_Over := Over;
      end Take;

      procedure Done is
      begin
         Taken := 0;
         Steps := (if Steps = Natural'Last then 0 else Steps + 1);
      end Done;

      procedure Close is
      begin
         Closed := True;
         Done;
      end Close;

      function Is_Closed return Boolean is (Closed);

      function Progress return Natural is (Steps);

      function Waiting return Natural is (Length + Taken);

   end Buffer;

end Partitions.Output_Buffers;
