--  SPDX-License-Identifier: Apache-2.0

with Host.Complaints;    use Host.Complaints;
with Host.Names;
with Host.Orders;
with Host.Text_Input;    use Host.Text_Input;
with Host.Text_Numbers;  use Host.Text_Numbers;
with Sim.Faults.Grammar; use Sim.Faults.Grammar;

package body Sim.Faults is

   use type Number;

   Longest_Time : constant Number := 10_000_000_000 * 1_000;

   procedure Read_Kind
     (From   : Reader;
      Before : Subject;
      Word   : String;
      Kind   : out Fault_Kind);

   --  The faults that may follow it, separated by bars.
   function Kinds_After (Before : Subject) return String;

   procedure Read_Time
     (From       : Reader;
      Field_Name : String;
      Word       : String;
      Value      : out Microseconds);

   --  From 0 to 1, as "0.001", "1e-3" or "1".
   procedure Read_Probability
     (From  : Reader;
      Word  : String;
      Value : out Probability);

   --  Reads a hexadecimal number from First to Last.
   procedure Read_Bits
     (From        : Reader;
      Field_Name  : String;
      Word        : String;
      First, Last : Number;
      Value       : out Number);

   --  Reads a whole number from First to Last.
   procedure Read_Number
     (From        : Reader;
      Field_Name  : String;
      Word        : String;
      First, Last : Number;
      Value       : out Number);

   procedure Read_Parameter
     (From : Reader;
      Item : Parameter;
      Word : String;
      Made : in out Fault);

   procedure Read_Servo
     (From  : Reader;
      Word  : String;
      Servo : out Servo_Item);

   --  Two faults never have the same line.
   function Is_Before (Left, Right : Fault) return Boolean is
     (if Left.Time = Right.Time then Left.Line < Right.Line
      else Left.Time < Right.Time);

   package Sorting is new Fault_Vectors.Generic_Sorting ("<" => Is_Before);

   --  Adds the fault to the list of its subject.
   procedure Distribute (To : in out Script; Given : Fault);

   procedure Read_Fault (From : Reader; Line : String; Made : out Fault);

   function Form_Of (Kind : Fault_Kind) return String renames Image;

   function Kinds_After (Before : Subject) return String is

      function List (From : Fault_Kind) return String;

      --  The kinds from there on.
      function List (From : Fault_Kind) return String is
         Here : constant String :=
           (if Forms (From).Before = Before then "|" & Name (From) else "");
      begin
         return
           (if From = Fault_Kind'Last then Here
            else Here & List (Fault_Kind'Succ (From)));
      end List;

      Whole : constant String := List (Fault_Kind'First);
   begin
      return Name (Before) & Whole (Whole'First + 1 .. Whole'Last);
   end Kinds_After;

   procedure Read_Kind
     (From   : Reader;
      Before : Subject;
      Word   : String;
      Kind   : out Fault_Kind)
   is
      Of_Nodes : constant String :=
        Kinds_After (A_Node) & ", " & Kinds_After (The_Ground);
      Choices  : constant String :=
        (case Before is
            when Nothing =>
              Kinds_After (Nothing) & ", " & Kinds_After (A_Path) & ", "
              & Of_Nodes & ", " & Kinds_After (A_Servo),
            when A_Node  => Of_Nodes,
            when others  => Kinds_After (Before));
   begin
      for Known in Fault_Kind loop
         if Name (Known) = Word then
            Kind := Known;
            return;
         end if;
      end loop;
      Refuse
        (From,
         (if Word = "" then "no fault follows"
          else "unknown fault " & Quoted (Word))
         & "; there are " & Choices);
   end Read_Kind;

   procedure Read_Time
     (From       : Reader;
      Field_Name : String;
      Word       : String;
      Value      : out Microseconds)
   is
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      Read_Decimal (Word, 3, Amount, Is_Valid);
      if not Is_Valid or else Amount > Longest_Time then
         Refuse
           (From,
            Field_Name & ": " & Quoted (Word) & " is not a time from 0 to"
            & Number'Image (Longest_Time / 1_000)
            & " ms with at most three decimals");
      end if;
      Value := Microseconds (Amount);
   end Read_Time;

   procedure Read_Probability
     (From  : Reader;
      Word  : String;
      Value : out Probability) is
   begin
      --  Ada accepts more forms than the format allows.
      for Char of Word loop
         if Char not in '0' .. '9' | '.' | 'e' | 'E' | '-' | '+' then
            raise Constraint_Error;
         end if;
      end loop;
      Value := Probability'Value (Word);
   exception
      when Constraint_Error =>
         Refuse
           (From,
            "P: " & Quoted (Word) & " is not a probability from 0 to 1");
   end Read_Probability;

   procedure Read_Bits
     (From        : Reader;
      Field_Name  : String;
      Word        : String;
      First, Last : Number;
      Value       : out Number)
   is
      Is_Valid : Boolean;
   begin
      Read_Hexadecimal (Word, Value, Is_Valid);
      if not Is_Valid or else Value not in First .. Last then
         Refuse
           (From,
            Field_Name & ": " & Quoted (Word)
            & " is not a hexadecimal number from "
            & Hexadecimal_Image (First) & " to " & Hexadecimal_Image (Last));
      end if;
   end Read_Bits;

   procedure Read_Number
     (From        : Reader;
      Field_Name  : String;
      Word        : String;
      First, Last : Number;
      Value       : out Number)
   is
      Is_Valid : Boolean;
   begin
      Read_Either (Word, Value, Is_Valid);
      if not Is_Valid or else Value not in First .. Last then
         Refuse
           (From,
            Field_Name & ": " & Quoted (Word) & " is not a whole number from"
            & First'Image & " to" & Last'Image);
      end if;
   end Read_Number;

   procedure Read_Servo
     (From  : Reader;
      Word  : String;
      Servo : out Servo_Item)
   is
      --  The names from that one on.
      function Names_From (Which : Servo_Item) return String is
        (Host.Names.Name (Which)
         & (if Which = Servo_Item'Last then ""
            else ", " & Names_From (Servo_Item'Succ (Which))));
   begin
      for Known in Servo_Item loop
         if Host.Names.Name (Known) = Word then
            Servo := Known;
            return;
         end if;
      end loop;
      Refuse
        (From,
         (if Word = "" then "no surface follows"
          else "unknown surface " & Quoted (Word))
         & "; there are " & Names_From (Servo_Item'First));
   end Read_Servo;

   procedure Read_Parameter
     (From : Reader;
      Item : Parameter;
      Word : String;
      Made : in out Fault)
   is
      Value    : Number;
      Is_Valid : Boolean;
   begin
      case Item is
         when None =>
            null;

         when A_Duration =>
            Read_Time (From, "DURATION_MS", Word, Made.Duration);

         when A_Probability =>
            Read_Probability (From, Word, Made.Rate);

         when An_Ordinal =>
            Read_Whole (Word, Value, Is_Valid);
            if not Is_Valid
              or else Value not in 1 .. Number (Byte_Ordinal'Last)
            then
               Refuse
                 (From,
                  "N: " & Quoted (Word)
                  & " is not a whole number from 1 to"
                  & Byte_Ordinal'Last'Image);
            end if;
            Made.Ordinal := Byte_Ordinal (Value);

         when A_Mask =>
            Read_Bits
              (From, "MASK", Word, 1, Number (Flip_Mask'Last), Value);
            Made.Mask := Flip_Mask (Value);

         when A_Byte =>
            Read_Bits (From, "BYTE", Word, 0, Number (Byte'Last), Value);
            Made.Inserted := Byte (Value);

         when A_ROM_Address =>
            Read_Bits
              (From, "ADDRESS", Word, 0, Number (ROM_Address'Last), Value);
            Made.Byte_At := ROM_Address (Value);

         when A_ROM_Mask =>
            Read_Bits (From, "MASK", Word, 1, Number (Byte'Last), Value);
            Made.Flips := Byte (Value);

         when A_RAM_Address =>
            Read_Bits
              (From, "ADDRESS", Word, 0, Number (RAM_Address'Last), Value);
            Made.Word_At := RAM_Address (Value);

         when A_RAM_Mask =>
            Read_Bits
              (From, "MASK", Word, 1, Number (URVOS.Word'Last), Value);
            Made.Zeros := URVOS.Word (Value);

         when A_Place =>
            Read_Number
              (From, "WORD", Word, 0, Number (Converter_Value'Last), Value);
            Made.Place := Converter_Value (Value);
            Made.Stays := False;

         when A_Speed =>
            Read_Number
              (From, "PERCENT", Word,
               Number (Surface_Faults.Percentage'First),
               Number (Surface_Faults.Percentage'Last), Value);
            Made.Speed := Surface_Faults.Percentage (Value);

         when A_Board =>
            if Word = "adc" then
               Made.Stalled := ADC;
            elsif Word = "telemetry" then
               Made.Stalled := Telemetry;
            else
               Refuse
                 (From,
                  "unknown board " & Quoted (Word)
                  & "; there are adc, telemetry");
            end if;

         when A_Restart =>
            if Word = "cold" then
               Made.How := Cold;
            elsif Word = "warm" then
               Made.How := Warm;
            elsif Word = "processor" then
               Made.How := Processor;
            elsif Word = "telemetry" then
               Made.How := Telemetry_Board;
            else
               Refuse
                 (From,
                  "unknown reset " & Quoted (Word)
                  & "; there are cold, warm, processor, telemetry");
            end if;
      end case;
   end Read_Parameter;

   procedure Read_Fault (From : Reader; Line : String; Made : out Fault) is
      Count  : constant Natural := Orders.Word_Count (Line);
      Next   : Positive := 2;
      Before : Subject := Nothing;
      Time   : Microseconds;
      Servo  : Servo_Item := Servo_Item'First;
      Kind   : Fault_Kind;

      function Word (Number : Positive) return String is
        (Orders.Word (Line, Number));

      --  Refuses parameters that the kind does not have.
      function Read_Rest return Fault;

      function Read_Rest return Fault is
         After  : constant Parameter_List := Forms (Kind).After;
         Most   : constant Natural :=
           (if After (1) = None then 0 elsif After (2) = None then 1 else 2);
         Wanted : constant Natural :=
           (if Is_Optional (After (1)) and then Count = Next then 0
            else Most);
      begin
         if (Before /= Forms (Kind).Before
             and then not (Forms (Kind).Before = The_Ground
                           and then Word (2) = "gsc"))
           or else Count - Next /= Wanted
         then
            Refuse
              (From, "the form of this fault is " & Image (Kind));
         end if;

         return Read : Fault (Kind) do
            Read.Line := Line_Number (From);
            Read.Time := Time;
            case Before is
               when Nothing => null;
               when A_Path  =>
                  Read.Path := (if Word (2) = "up" then Up else Down);
               when A_Node | The_Ground =>
                  if Kind in Stall | Hardware_Fault then
                     Read.Where :=
                       (if Word (2) = "mcs" then Aircraft else Ground);
                  end if;
               when A_Servo =>
                  Read.Servo := Servo;
            end case;
            for Index in 1 .. Wanted loop
               Read_Parameter (From, After (Index), Word (Next + Index), Read);
            end loop;
         end return;
      end Read_Rest;
   begin
      Read_Time (From, "TIME_MS", Word (1), Time);

      if Count < 2 then
         Refuse (From, "no fault follows the time");
      elsif Word (2) = "up" or else Word (2) = "down" then
         Before := A_Path;
         Next   := 3;
      elsif Word (2) = "mcs" or else Word (2) = "gsc" then
         Before := A_Node;
         Next   := 3;
      elsif Word (2) = Servo_Word then
         Before := A_Servo;
         Read_Servo (From, Word (3), Servo);
         Next := 4;
      end if;

      Read_Kind (From, Before, Word (Next), Kind);
      Made := Read_Rest;
   end Read_Fault;

   procedure Distribute (To : in out Script; Given : Fault) is
      Span : constant Windows.Window :=
        (Given.Time, Given.Time + Given.Duration);
   begin
      case Given.Kind is
         when Cut =>
            Windows.Add (To.Cuts, Span);
         when Lost_Console =>
            Windows.Add (To.Consoles, Span);
         when Bit_Errors =>
            To.Paths (Given.Path).Noises.Append (Given);
         when Replay =>
            To.Paths (Given.Path).Replays.Append (Given);
         when Character_Fault =>
            To.Paths (Given.Path).Characters.Append (Given);
         when Stall =>
            Windows.Add (To.Stalls (Given.Where, Given.Stalled), Span);
         when Hardware_Fault =>
            To.Hardware.Append (Given);
         when Servo_Fault =>
            To.Servos.Append (Given);
      end case;
   end Distribute;

   procedure Load (Loaded : out Script; File : String) is

      Every : Fault_List;

      procedure Read (From : Reader; Order : String);

      procedure Read (From : Reader; Order : String) is
         Made : Fault;
      begin
         Read_Fault (From, Order, Made);
         Every.Append (Made);
      end Read;

      procedure Read_All is new Orders.Read_All (Read);
   begin
      Read_All (File);
      Sorting.Sort (Every);
      Loaded := (others => <>);
      for Each of Every loop
         Distribute (Loaded, Each);
      end loop;
      Loaded.Every := Every;
   end Load;

   function Number_From
     (From : Script; Time : Microseconds) return Natural
   is
      Found : Natural := 0;
   begin
      for Each of From.Every loop
         Found := Found + (if Each.Time >= Time then 1 else 0);
      end loop;
      return Found;
   end Number_From;

   function For_Plant
     (From : Script; Begins : Microseconds) return Surface_Faults.List
   is
      use Surface_Faults;

      --  The first step that does not begin before the time.
      function Step_At (Time : Microseconds) return Step_Number is
        (if Time <= Begins then 0
         else Step_Number ((Time - Begins + Tick_Time - 1) / Tick_Time));
   begin
      return Found : Surface_Faults.List do
         for Each of From.Servos loop
            Found.Append
              (Surface_Faults.Fault'
                 (Servo => Each.Servo,
                  Start => Step_At (Each.Time),
                  Kind  =>
                    (case Servo_Fault'(Each.Kind) is
                        when Stuck =>
                          (if Each.Stays then Stuck_Here else Stuck_At),
                        when Float => Floating,
                        when Slow  => Slow),
                  Place => Each.Place,
                  Speed => Each.Speed));
         end loop;
      end return;
   end For_Plant;

end Sim.Faults;
