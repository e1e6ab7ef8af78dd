--  SPDX-License-Identifier: Apache-2.0

--  An analog-to-digital board with the scan that its interrupt handler makes,
--  shared by the controller and the board's hardware (report, 4.1, 4.2; AD-1,
--  ADI-1).

with Devices.AD_Board; use Devices.AD_Board;
with URVOS;            use URVOS;
with URV.AD_Scans;     use URV.AD_Scans;
with URV.Buffers;      use URV.Buffers;

package URV.AD_Boards with SPARK_Mode is

   protected type Board is

      --  The controller's side

      procedure Initialise;

      --  Begins a scan with channel 0. Reached is the number of channels that
      --  the last scan converted.
      procedure Begin_Scan (Reached : out Channel_Count);

      --  The interrupt: stores the board's Value, and starts the next channel
      --  if there is one.
      procedure Take_Value (Value : out Word; Next : out Next_Step);

      function Words return Channel_Words;

      --  The hardware's side

      --  Wanted is True if a conversion of Channel was started since the last
      --  call.
      procedure Take_Start
        (Wanted  : out Boolean;
         Channel : out Channel_Number);

      --  The conversion is done; Interrupt says whether to interrupt the
      --  controller. If the controller has abandoned this conversion, which
      --  the hardware may not know yet, it is not interrupted and the value is
      --  discarded.
      procedure Finish (Value : Word; Interrupt : out Boolean);

      --  Both sides on a machine whose own interrupt ends the conversion: the
      --  same as Finish, Take_Value if it interrupts, and Take_Start.
      procedure Pass_Value (Value : Word; Next : out Successor);

   private
      Contents : Registers;
      Item     : Scan;
   end Board;

end URV.AD_Boards;
