--  SPDX-License-Identifier: Apache-2.0

--  The flight record: one row for each major frame of the ground node, taken
--  as that frame ends (--record).

with Host.Plant_Messages; use Host.Plant_Messages;
with Host.Text_Output;
with URV.Buffers;         use URV.Buffers;
with URV.Card_Status;
with URV.Law_Status;
with URV.Test_Runs;
with URVOS;               use URVOS;

package Sim.Flight_Record is

   --  All values of a row, in the order of the columns. GSC and MCS are the
   --  contents of that node's CORE memory.
   type Row is record
      Frame        : Count;
      Time         : Microseconds;
      Console      : Console_Words;
      GSC_Uplink   : Uplink_Buffer;
      MCS_Uplink   : Uplink_Buffer;
      PWM          : PWM_Buffer;
      MCS_Downlink : Downlink_Buffer;
      GSC_Downlink : Downlink_Buffer;
      Link         : Link_Counts;
      MCS_Frame    : Frame_Words;
      GSC_Frame    : Frame_Words;

      --  With an aircraft, its true state.
      Has_Truth    : Boolean;
      Truth        : Shown_State;

      --  With control laws, their report, in the aircraft and as the ground
      --  knows it.
      Has_Laws         : Boolean;
      Laws             : URV.Law_Status.Report;
      Reported_Laws    : URV.Law_Status.Report;

      --  With orders of the ground, the settings, too.
      Has_Orders   : Boolean;

      --  With test cards among them, their state and inputs, and their report
      --  as the ground knows it.
      Has_Cards    : Boolean;
      Cards        : URV.Test_Runs.Aboard;
      Cards_Told   : URV.Card_Status.Report;
   end record;

   --  Writes the line with the names of the columns.
   procedure Write_Header
     (To         : in out Text_Output.Writer;
      Has_Truth  : Boolean;
      Has_Laws   : Boolean;
      Has_Orders : Boolean;
      Has_Cards  : Boolean)
     with Pre => Text_Output.Is_Open (To);

   --  Writes one row. A time that is no whole number of milliseconds gets
   --  three decimals.
   procedure Write_Row (To : in out Text_Output.Writer; This : Row)
     with Pre => Text_Output.Is_Open (To);

end Sim.Flight_Record;
