with Ada.Real_Time; use Ada.Real_Time;
with MCS.Real_Time;

package body Real_Time_MCS with SPARK_Mode is

   procedure Observe_Tick (Late : Time_Span) is null;

   procedure AD_Step (First_Run : Boolean; Failed : out Boolean);
   procedure TELIN_Step (First_Run : Boolean; Failed : out Boolean);
   procedure MDCIN_Step (First_Run : Boolean; Failed : out Boolean);
   procedure MDCOUT_Step (First_Run : Boolean; Failed : out Boolean);
   procedure PWM_Step (First_Run : Boolean; Failed : out Boolean);
   procedure TELOUT_Step (First_Run : Boolean; Failed : out Boolean);
   procedure CORE_Step (First_Run : Boolean; Failed : out Boolean);
   procedure LOG_Step (First_Run : Boolean; Failed : out Boolean);
   procedure SELF_TEST_Step (First_Run : Boolean; Failed : out Boolean);

   procedure AD_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         MCS.AD.Initialise;
      else
         MCS.AD.Run_Transaction;
      end if;
   end AD_Step;

   procedure TELIN_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         MCS.TELIN.Initialise;
      else
         MCS.TELIN.Run_Transaction;
      end if;
   end TELIN_Step;

   procedure MDCIN_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         MCS.MDCIN.Run_Transaction;
      end if;
   end MDCIN_Step;

   procedure MDCOUT_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         MCS.MDCOUT.Run_Transaction;
      end if;
   end MDCOUT_Step;

   procedure PWM_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         MCS.PWM.Run_Transaction;
      end if;
   end PWM_Step;

   procedure TELOUT_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if not First_Run then
         MCS.TELOUT.Run_Transaction;
      end if;
   end TELOUT_Step;

   procedure CORE_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         MCS.CORE.Initialise;
      else
         MCS.CORE.Run_Transaction;
      end if;
   end CORE_Step;

   procedure LOG_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         MCS.LOG.Initialise;
      else
         MCS.LOG.Run_Transaction;
      end if;
   end LOG_Step;

   procedure SELF_TEST_Step (First_Run : Boolean; Failed : out Boolean) is
   begin
      Failed := False;
      if First_Run then
         MCS.SELF_TEST.Initialise;
      else
         MCS.SELF_TEST.Run_Transaction;
      end if;
   end SELF_TEST_Step;

   package Partition is new MCS.Real_Time
     (AD_Step        => AD_Step,
      TELIN_Step     => TELIN_Step,
      MDCIN_Step     => MDCIN_Step,
      MDCOUT_Step    => MDCOUT_Step,
      PWM_Step       => PWM_Step,
      TELOUT_Step    => TELOUT_Step,
      CORE_Step      => CORE_Step,
      LOG_Step       => LOG_Step,
      SELF_TEST_Step => SELF_TEST_Step,
      Observe_Tick   => Observe_Tick);

   procedure Switch_On is
   begin
      Partition.Switch_On;
   end Switch_On;

end Real_Time_MCS;
