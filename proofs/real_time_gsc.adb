with Ada.Real_Time; use Ada.Real_Time;
with GSC.Real_Time;

package body Real_Time_GSC with SPARK_Mode is

   procedure Observe_Tick (Late : Time_Span) is null;

   procedure AD_Step (First_Run : Boolean; Failed : out Boolean);
   procedure TELIN_Step (First_Run : Boolean; Failed : out Boolean);
   procedure GDCIN_Step (First_Run : Boolean; Failed : out Boolean);
   procedure GDCOUT_Step (First_Run : Boolean; Failed : out Boolean);
   procedure TELOUT_Step (First_Run : Boolean; Failed : out Boolean);
   procedure CORE_Step (First_Run : Boolean; Failed : out Boolean);
   procedure LOG_Step (First_Run : Boolean; Failed : out Boolean);
   procedure SELF_TEST_Step (First_Run : Boolean; Failed : out Boolean);

   procedure AD_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         GSC.AD.Initialise;
      else
         GSC.AD.Run_Transaction;
      end if;
   end AD_Step;

   procedure TELIN_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         GSC.TELIN.Initialise;
      else
         GSC.TELIN.Run_Transaction;
      end if;
   end TELIN_Step;

   procedure GDCIN_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         GSC.GDCIN.Run_Transaction;
      end if;
   end GDCIN_Step;

   procedure GDCOUT_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         GSC.GDCOUT.Run_Transaction;
      end if;
   end GDCOUT_Step;

   procedure TELOUT_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         GSC.TELOUT.Run_Transaction;
      end if;
   end TELOUT_Step;

   procedure CORE_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         GSC.CORE.Initialise;
      else
         GSC.CORE.Run_Transaction;
      end if;
   end CORE_Step;

   procedure LOG_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         GSC.LOG.Initialise;
      else
         GSC.LOG.Run_Transaction;
      end if;
   end LOG_Step;

   procedure SELF_TEST_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         GSC.SELF_TEST.Initialise;
      else
         GSC.SELF_TEST.Run_Transaction;
      end if;
   end SELF_TEST_Step;

   package Partition is new GSC.Real_Time
     (AD_Step        => AD_Step,
      TELIN_Step     => TELIN_Step,
      GDCIN_Step     => GDCIN_Step,
      GDCOUT_Step    => GDCOUT_Step,
      TELOUT_Step    => TELOUT_Step,
      CORE_Step      => CORE_Step,
      LOG_Step       => LOG_Step,
      SELF_TEST_Step => SELF_TEST_Step,
      Observe_Tick   => Observe_Tick);

   procedure Switch_On is
   begin
      Partition.Switch_On;
   end Switch_On;

end Real_Time_GSC;
