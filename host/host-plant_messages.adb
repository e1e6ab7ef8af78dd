--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Characters.Latin_1;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Unchecked_Conversion;
with Interfaces;            use Interfaces;

with Host.Names;        use Host.Names;
with Host.Scaling;      use Host.Scaling;
with Host.Text_Numbers; use Host.Text_Numbers;

package body Host.Plant_Messages is

   Line_Feed : constant Character := Ada.Characters.Latin_1.LF;

   --  The fields of Flight_State, in order.
   type Truth_Item is
     (Altitude, Airspeed, Bank, Pitch, Heading, Climb, North, East, Wheels,
      Crashed);

   Truth_Names : constant String :=
     "truth,altitude,ft" & Line_Feed
     & "truth,airspeed,kt" & Line_Feed
     & "truth,bank,deg" & Line_Feed
     & "truth,pitch,deg" & Line_Feed
     & "truth,heading,deg" & Line_Feed
     & "truth,climb,ft/s" & Line_Feed
     & "truth,north,ft" & Line_Feed
     & "truth,east,ft" & Line_Feed
     & "truth,wheels,on ground" & Line_Feed
     & "truth,crashed,yes" & Line_Feed;

   Shown_Names : constant String :=
     "shown,altitude,ft" & Line_Feed
     & "shown,airspeed,kt" & Line_Feed
     & "shown,bank,deg" & Line_Feed
     & "shown,pitch,deg" & Line_Feed
     & "shown,heading,deg" & Line_Feed
     & "shown,alpha,deg" & Line_Feed
     & "shown,beta,deg" & Line_Feed
     & "shown,north,ft" & Line_Feed
     & "shown,east,ft" & Line_Feed;

   pragma Assert
     (Truth_Item'Pos (Truth_Item'Last) + 1 = Truth_Count);

   function To_Bits is new Ada.Unchecked_Conversion (Long_Float, Unsigned_64);
   function To_Number is
     new Ada.Unchecked_Conversion (Unsigned_64, Long_Float);

   function Fault_Line (Item : Surface_Faults.Fault) return String;

   procedure Put
     (Message : in out Stream_Element_Array;
      Last    : in out Stream_Element_Offset;
      Value   : Long_Float);

   --  Reads the next number. Raises Not_Finite with its name.
   procedure Get
     (Message : Stream_Element_Array;
      Last    : in out Stream_Element_Offset;
      Name    : String;
      Value   : out Long_Float);

   function Time_Line (Name : String; Value : Positive; Unit : String)
                       return String
   is ("time," & Name & ',' & Image (Long_Long_Integer (Value)) & ' ' & Unit
       & Line_Feed);

   procedure Put
     (Message : in out Stream_Element_Array;
      Last    : in out Stream_Element_Offset;
      Value   : Long_Float)
   is
      Bits : Unsigned_64 := To_Bits (Value);
   begin
      for Index in reverse Last + 1 .. Last + Bytes_Per_Number loop
         Message (Index) := Stream_Element (Bits and 16#FF#);
         Bits := Shift_Right (Bits, 8);
      end loop;
      Last := Last + Bytes_Per_Number;
   end Put;

   procedure Get
     (Message : Stream_Element_Array;
      Last    : in out Stream_Element_Offset;
      Name    : String;
      Value   : out Long_Float)
   is
      Exponent : constant Unsigned_64 := 16#7FF0_0000_0000_0000#;
      Bits     : Unsigned_64 := 0;
   begin
      for Index in Last + 1 .. Last + Bytes_Per_Number loop
         Bits := Shift_Left (Bits, 8) or Unsigned_64 (Message (Index));
      end loop;
      Last  := Last + Bytes_Per_Number;
      if (Bits and Exponent) = Exponent then
         raise Not_Finite with
           "the aircraft's " & Name & " is not a finite number";
      end if;
      Value := To_Number (Bits);
   end Get;

   procedure Read
     (Message : State_Message;
      Sensors : out Sensor_Words;
      Truth   : out Flight_State;
      Shown   : out Shown_State;
      Errors  : Sensor_Values := Exact)
   is
      Last    : Stream_Element_Offset := 0;
      Value   : Long_Float;
      Numbers : array (Truth_Item) of Long_Float;
   begin
      for Item in Sensor_Item loop
         Get (Message, Last, Name (Item), Value);
         Sensors (Item) :=
           To_Word (Value + Errors (Item), Scaling.Sensors (Item));
      end loop;
      for Item in Truth_Item loop
         Get (Message, Last, To_Lower (Item'Image), Numbers (Item));
      end loop;
      Truth :=
        (Altitude => Numbers (Altitude),
         Airspeed => Numbers (Airspeed),
         Bank     => Numbers (Bank),
         Pitch    => Numbers (Pitch),
         Heading  => Numbers (Heading),
         Climb    => Numbers (Climb),
         North    => Numbers (North),
         East     => Numbers (East),
         Wheels   => Numbers (Wheels),
         Crashed  => Numbers (Crashed) /= 0.0);
      for Item in Shown_Item loop
         Get (Message, Last, To_Lower (Item'Image), Shown (Item));
      end loop;
   end Read;

   function Fault_Line (Item : Surface_Faults.Fault) return String is
     ("fault," & Name (Item.Servo) & ','
      & Image (Long_Long_Integer (Item.Start)) & ' '
      & (case Item.Kind is
            when Surface_Faults.Stuck_Here => "stuck",
            when Surface_Faults.Stuck_At   =>
              "stuck "
              & Long_Float'Image
                  (To_Unit (Item.Place, Scaling.Servos (Item.Servo))),
            when Surface_Faults.Floating   => "float",
            when Surface_Faults.Slow       =>
              "slow " & Image (Long_Long_Integer (Item.Speed)))
      & Line_Feed);

   function Fault_Lines (Faults : Surface_Faults.List) return String is
      Text : Unbounded_String;
   begin
      for Item of Faults loop
         Append (Text, Fault_Line (Item));
      end loop;
      return To_String (Text);
   end Fault_Lines;

   function Introduction
     (Shown_After : Step_Count;
      Further     : String := "";
      Schedule    : Schedule_Name := URVOS.Task_Trees.Report)
      return Stream_Element_Array
   is
      Text : Unbounded_String;
   begin
      for Item in Servo_Item loop
         Append
           (Text,
            "servo," & Name (Item) & ','
            & Symbol (Servos (Item).Measured_In) & Line_Feed);
      end loop;
      for Item in Sensor_Item loop
         Append
           (Text,
            "sensor," & Name (Item) & ','
            & Symbol (Sensors (Item).Measured_In) & Line_Feed);
      end loop;
      Append
        (Text,
         Truth_Names & Shown_Names
         & Time_Line ("tick", Microseconds_Per_Tick, "us")
         & Time_Line ("frame", Ticks_Per_Major_Frame, "ticks")
         & Time_Line ("scan", Ticks_To_Scan (Schedule), "ticks")
         & Time_Line ("shown", Shown_After, "ticks")
         & Further & Line_Feed);

      return Bytes : Stream_Element_Array
        (1 .. Stream_Element_Offset (Length (Text)))
      do
         for Index in Bytes'Range loop
            Bytes (Index) :=
              Character'Pos (Element (Text, Positive (Index)));
         end loop;
      end return;
   end Introduction;

   function To_Message (Servos : PWM_Buffer) return Command_Message is
      Last : Stream_Element_Offset := 0;
   begin
      return Message : Command_Message do
         for Item in Servo_Item loop
            Put
              (Message, Last,
               To_Unit (Servos (Item), Scaling.Servos (Item)));
         end loop;
      end return;
   end To_Message;

end Host.Plant_Messages;
