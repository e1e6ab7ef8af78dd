--  SPDX-License-Identifier: Apache-2.0

with GSC;
with Partitions.Octets;   use Partitions.Octets;
with URV.Buffers;         use URV.Buffers;
with URV.Recorder_Blocks; use URV.Recorder_Blocks;
with URV.Recorder_Steps;
with URV.Type_Codes;      use URV.Type_Codes;

package body Partitions.Recorder_Answers is

   Magic   : constant := 16#5552_5652#;
   Version : constant := 1;
   Length  : constant := 4 + 2 + 2 + 2 + 2 * (Sensor_Item'Pos
                           (Sensor_Item'Last) + 1);

   --  From the console's port to the node.
   protected Asker is
      procedure Write (Port : File; Where : Socket_Address; Long : unsigned);
      procedure Read
        (Port : out File; Where : out Socket_Address; Long : out unsigned);
   private
      Kept_Port   : File := Invalid;
      Kept_Where  : Socket_Address := (others => 0);
      Kept_Length : unsigned := 0;
   end Asker;

   protected body Asker is

      procedure Write (Port : File; Where : Socket_Address; Long : unsigned)
      is
      begin
         Kept_Port := Port;
         Kept_Where := Where;
         Kept_Length := Long;
      end Write;

      procedure Read
        (Port : out File; Where : out Socket_Address; Long : out unsigned) is
      begin
         Port := Kept_Port;
         Where := Kept_Where;
         Long := Kept_Length;
      end Read;

   end Asker;

   procedure Send (Block : Downlink_Buffer);

   procedure Send (Block : Downlink_Buffer) is
      Bytes : Octet_Array (1 .. Length);
      Last  : Natural := 0;
      Port  : File;
      Where : Socket_Address;
      Long  : unsigned;

      Unused_Sent : Byte_Total;
   begin
      Asker.Read (Port, Where, Long);
      if Port = Invalid then
         return;
      end if;
      Append (Bytes, Last, Magic, 4);
      Append (Bytes, Last, Version, 2);
      Append (Bytes, Last, Length, 2);
      Append (Bytes, Last, Number (Kind_Of (Block)), 2);
      for Name in Sensor_Item loop
         Append (Bytes, Last, Number (Block (Name)), 2);
      end loop;

      --  A datagram that is lost is asked for again.
      Unused_Sent := Send_To
        (Port, Bytes'Address, Bytes'Length, Dont_Wait + No_Signal,
         Where'Address, Long);
   end Send;

   function Is_Flying return Boolean is
     (URV.Recorder_Steps.Is_Flying
        ((GSC.CORE_Memory.Contents.Downlink with delta
            Error_Status => No_Error)));

   procedure Note_Sender
     (Port : File; Where : Socket_Address; Length : unsigned) is
   begin
      Asker.Write (Port, Where, Length);
   end Note_Sender;

   procedure Refuse_In_Flight is
   begin
      Send (Report_Of (Flies, (Length => 1, others => <>)));
   end Refuse_In_Flight;

   procedure Pass_On is
      Block  : Downlink_Buffer;
      Is_New : Boolean;
   begin
      GSC.Recorder_Blocks.Look (Block, Is_New);
      if Is_New then
         Send (Block);
      end if;
   end Pass_On;

end Partitions.Recorder_Answers;
