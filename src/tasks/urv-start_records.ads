--  What is kept of a start, for later analysis (report, 2.3.4; INI-6,
--  TST-4): CORE's status says which starts there were and what the last
--  one's self-test found; the error log has the warm ones and the failures.

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS;               use URVOS;
with URVOS.Self_Tests;    use URVOS.Self_Tests;
with URVOS.Starts;        use URVOS.Starts;
with URV.Errors;          use URV.Errors;

generic
   with procedure Inspect_CORE (Snapshot : out Memory);
   with procedure Write_Status (Words : Status_Array);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.Start_Records with SPARK_Mode is

   procedure Record_Start
     (Condition : Starts.Start_Condition;
      Result    : Test_Result);

end URV.Start_Records;
