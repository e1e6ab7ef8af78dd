with Board_Memory_Tests;
with Buffers_Tests;
with Checksum_Tests;
with Codecs_Tests;
with Frames_Tests;
with Headers_Tests;
with Link_Tests;
with Mailboxes_Tests;
with Node_Tests;
with PWM_Tests;
with Receivers_Tests;
with Scan_Tests;
with Senders_Tests;

package body All_Tests is

   --  The tests, in order.

   -----------
   -- Suite --
   -----------

   function Suite return AUnit.Test_Suites.Access_Test_Suite is
      Result : constant AUnit.Test_Suites.Access_Test_Suite :=
        AUnit.Test_Suites.New_Suite;
   begin
      Frames_Tests.Add_To (Result);
      Mailboxes_Tests.Add_To (Result);
      Checksum_Tests.Add_To (Result);
      Headers_Tests.Add_To (Result);
      Board_Memory_Tests.Add_To (Result);
      Receivers_Tests.Add_To (Result);
      Senders_Tests.Add_To (Result);
      Link_Tests.Add_To (Result);
      Buffers_Tests.Add_To (Result);
      Codecs_Tests.Add_To (Result);
      PWM_Tests.Add_To (Result);
      Scan_Tests.Add_To (Result);
      Node_Tests.Add_To (Result);
      return Result;
   end Suite;

end All_Tests;
