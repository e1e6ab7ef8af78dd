--  SPDX-License-Identifier: Apache-2.0

with GNAT.OS_Lib;
with Interfaces.C; use Interfaces.C;

with Host.Complaints;         use Host.Complaints;
with Partitions.System_Calls; use Partitions.System_Calls;

package body Partitions.Serial_Lines is

   Baud : constant := 125_000;

   --  Flags of struct termios2.
   Mark_Errors    : constant unsigned := 8#10#;
   Check_Parity   : constant unsigned := 8#20#;
   Eight_Bits     : constant unsigned := 8#60#;
   Two_Stop_Bits  : constant unsigned := 8#100#;
   Receiver_On    : constant unsigned := 8#200#;
   Even_Parity    : constant unsigned := 8#400#;
   No_Modem       : constant unsigned := 8#4000#;
   Any_Speed      : constant unsigned := 8#010000#;

   procedure Refuse_Device (Device, Problem : String) with No_Return;

   procedure Set_Line (Device : String; Line : File);

   procedure Refuse_Device (Device, Problem : String) is
   begin
      Refuse ("--link: " & Quoted ("serial:" & Device) & " " & Problem);
   end Refuse_Device;

   procedure Set_Line (Device : String; Line : File) is
      Settings : Line_Settings;
   begin
      if Control (Line, Get_Settings, Settings) /= 0 then
         Refuse_Device (Device, "is not a serial device");
      end if;

      Settings :=
        (Settings with delta
           Input_Flags   => Mark_Errors + Check_Parity,
           Output_Flags  => 0,
           Control_Flags => Eight_Bits + Two_Stop_Bits + Receiver_On
                            + Even_Parity + No_Modem + Any_Speed,
           Local_Flags   => 0,
           Characters    => (others => 0),
           Input_Speed   => Baud,
           Output_Speed  => Baud);
      if Control (Line, Set_Settings, Settings) /= 0
        or else Control (Line, Get_Settings, Settings) /= 0
      then
         Refuse_Device
           (Device, "cannot be set: " & GNAT.OS_Lib.Errno_Message);

      --  A character of 12 bits tolerates two per cent.
      elsif Settings.Output_Speed not in Baud - 2_500 .. Baud + 2_500 then
         Refuse_Device
           (Device,
            "cannot do 125000 baud, only"
            & Settings.Output_Speed'Image);
      end if;
   end Set_Line;

   function Opened (Device : String) return File is
      Line : constant File :=
        Open (To_C (Device), Read_Write + No_Controlling + Non_Blocking);
   begin
      if Line = Invalid then
         Refuse_Device
           (Device, "cannot be opened: " & GNAT.OS_Lib.Errno_Message);
      elsif Lock (Line, Exclusively + Without_Wait) /= 0 then
         Refuse_Device (Device, "is in use by another program");
      end if;
      Set_Line (Device, Line);

      --  Earlier characters on the line are discarded.
      if Control (Line, Flush, Flush_Both) /= 0 then
         Refuse_Device
           (Device, "cannot be emptied: " & GNAT.OS_Lib.Errno_Message);
      end if;
      return Line;
   end Opened;

end Partitions.Serial_Lines;
