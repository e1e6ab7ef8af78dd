--  SPDX-License-Identifier: Apache-2.0

--  LAW task: the control laws, between MDCIN and PWM (EXT-3, EXT-5; the report
--  leaves them for later versions). Released at minor frame 1 of the report's
--  schedule, after the tasks that produce its inputs.
--
--  Consumes commands_variable and sensors_variable, produces PWM_variable.
--  With the laws off it passes the commands on unchanged. It reports changes
--  of the link, invalid sensors, and failed surfaces. While a law flies, the
--  other surfaces make up for a failed one (EXT-6).
--
--  A configuration from the ground is taken, or refused and reported, before
--  the laws use it (EXT-2), and so is a test card, which then runs by switch 5
--  (FTI-2, FTI-4). Each downlink reports the running one (FTI-12).
--
--  Each of these jobs has a package of its own (D-43). URV.LAW_Steps has the
--  decision of all of them.

with URV.Mailboxes;     use URV.Mailboxes;
with URV.Shared_Cards;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Inputs;
with URV.Shared_Laws;
with URV.Shared_Surfaces;

generic
   Commands_Variable : in out For_Uplink.Variable;
   Sensors_Variable  : in out For_Downlink.Variable;
   PWM_Variable      : in out For_Uplink.Variable;
   Configuration_Variable : in out For_Uplink.Variable;
   Law_Settings      : in out URV.Shared_Laws.Settings.Store;
   Law_Memory        : in out URV.Shared_Laws.Memory_Store;
   Law_Record        : in out URV.Shared_Laws.Records.Store;
   Surface_Health    : in out URV.Shared_Surfaces.Healths.Store;
   Test_Added        : in out URV.Shared_Inputs.Store;
   Card_Shown        : in out URV.Shared_Cards.Store;
   Errors            : in out Shared_Log;
package URV.LAW_Task with SPARK_Mode is

   procedure Run_Transaction
   with
     Global =>
       (Input  => Law_Settings,
        In_Out => (Commands_Variable, Sensors_Variable, PWM_Variable,
                   Configuration_Variable, Law_Memory, Law_Record,
                   Surface_Health, Test_Added, Card_Shown, Errors));

end URV.LAW_Task;
