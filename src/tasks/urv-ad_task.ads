--  AD task: hands on the scan of the last frame and begins the next one
--  (report, 4.1, table 1; AD-1). Released at minor frame 0.
--
--  Consumes ADINT_variable, produces AD_variable. A frame without a scan
--  passes on the words of the one before, with the error word set.

with URVOS;       use URVOS;
with URV.AD_Scans; use URV.AD_Scans;
with URV.Buffers; use URV.Buffers;
with URV.Errors;  use URV.Errors;

generic
   with procedure Receive_ADINT
     (Words : out Channel_Words; Fresh : out Boolean);
   with procedure Send_AD (Image : AD_Image; Success : out Boolean);
   with procedure Begin_Scan (Reached : out Channel_Count);
   with procedure Report (Error : Error_Kind; Detail : Word);
package URV.AD_Task with SPARK_Mode is

   procedure Initialise;

   procedure Run_Transaction;

end URV.AD_Task;
