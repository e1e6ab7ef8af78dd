--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Seals with SPARK_Mode is

   procedure One_More_May_Be_Lost (Number, Most : Counter) is null;

   procedure All_Words_Come_Through
     (Data : Block_Data; Number, Echo : Counter) is null;

   procedure The_Newest_Opens_Again
     (Item : Session; Block : Block_Data) is null;

   procedure Every_Block_Is_A_Frame_Younger
     (Item : Session; Number, Echo, Sealed_At : Counter) is null;

   procedure Seven_Bytes_Are_Enough
     (Block : Block_Data; With_Key : Key) is null;

end Canaries.Seals;
