--  SPDX-License-Identifier: Apache-2.0

--  The flight record: one row for each major frame of the ground node,
--  taken as that frame ends (--record).

with Devices.CORE_Memory; use Devices.CORE_Memory;
with Host.Plant_Messages; use Host.Plant_Messages;
with Host.Text_Output;
with URV.Buffers;         use URV.Buffers;
with URVOS;               use URVOS;

package Sim.Flight_Record is

   --  Everything of a row, in the order of the columns. GSC and MCS stand
   --  for what that node's CORE memory holds.
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

      --  Where an aircraft flies, what it really does.
      Has_Truth    : Boolean;
      Truth        : Shown_State;

      --  Where there are control laws, what they say of themselves, in the
      --  aircraft and as the ground knows it.
      Has_Laws     : Boolean;
      Laws         : Log_Row;
      Laws_Told    : Log_Row;

      --  The ground orders more than the sticks: what was set, too.
      Has_Orders   : Boolean;
   end record;

   --  Writes the line with the names of the columns.
   procedure Write_Header
     (To         : in out Text_Output.Writer;
      Has_Truth  : Boolean;
      Has_Laws   : Boolean;
      Has_Orders : Boolean)
     with Pre => Text_Output.Is_Open (To);

   --  Writes one row. A time that is no whole number of milliseconds gets
   --  three decimals.
   procedure Write_Row (To : in out Text_Output.Writer; This : Row)
     with Pre => Text_Output.Is_Open (To);

end Sim.Flight_Record;
