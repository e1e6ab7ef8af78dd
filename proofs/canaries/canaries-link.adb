--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Link with SPARK_Mode is

   package body Boards is

      procedure Headers_Are_Farther_Apart (Left, Right : Byte) is null;

      procedure Two_Steps_Distinguish
        (Left, Right : Byte; Data, Other : Byte) is null;

      procedure Ground_Need_Not_Wait (Item : in out Board) is
      begin
         Elapse (Item, Dead_Space - 1);
      end Ground_Need_Not_Wait;

      procedure Last_Byte_Fills_The_Buffer
        (Item         : in out Receiver;
         Pair         : in out Buffer_Pair;
         Data         : Byte;
         Parity_Error : Boolean;
         Outcome      : out Event)
      is
      begin
         Accept_Character (Item, Pair, 28, True, Data, Parity_Error, Outcome);
      end Last_Byte_Fills_The_Buffer;

      procedure Late_Character_Is_Bad
        (Item         : in out Board;
         Data         : Byte;
         Parity_Error : Boolean)
      is
      begin
         Elapse (Item, Guard_Time);
         Accept_Character (Item, Data, Parity_Error);
      end Late_Character_Is_Bad;

      procedure Every_Character_Is_Data
        (Item   : Sender;
         Data   : Block_Data;
         Output : Byte) is null;

      procedure A_Filled_Place_Was_Empty (Pair : Buffer_Pair) is null;

      procedure Nothing_Is_Overwritten
        (Item         : in out Board;
         Data         : Byte;
         Parity_Error : Boolean)
      is
      begin
         Accept_Character (Item, Data, Parity_Error);
      end Nothing_Is_Overwritten;

   end Boards;

   package body Seals is

      procedure One_More_May_Be_Lost (Number, Most : Counter) is null;

      procedure All_Words_Come_Through
        (Data : Block_Words; Number, Echo : Counter) is null;

      procedure The_Newest_Opens_Again
        (Item : Session; Block : Block_Data) is null;

      procedure Every_Block_Is_A_Frame_Younger
        (Item : Session; Number, Echo, Sealed_At : Counter) is null;

      procedure Seven_Bytes_Are_Enough
        (Block : Block_Data; With_Key : Key) is null;

   end Seals;

   package body Data_Path is

      procedure Roll_Reaches_The_Aileron (Commands : Uplink_Buffer) is null;

      procedure Low_Byte_Comes_First (High, Low : Byte) is null;

      procedure Clock_Runs (Now : Clock_Tick) is null;

   end Data_Path;

   package body In_Step is

      procedure It_Is_Always_A_Tick_Before (Item : Situation) is null;

      procedure Ten_Ticks_Are_A_Frame
        (Clock   : Frame_Clock;
         Request : Frame_Request)
      is null;

   end In_Step;

   package body Latency is

      procedure A_Sensor_Is_A_Microsecond_Earlier (Item : Situation) is
      begin
         In_Step_Is_In_Time (Item);
      end A_Sensor_Is_A_Microsecond_Earlier;

   end Latency;

end Canaries.Link;
