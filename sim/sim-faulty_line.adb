package body Sim.Faulty_Line is

   use type Faults.Character_Bits;

   Parity_Bit : constant Faults.Character_Bits := 2 ** 8;

   --  The order in which faults become due: by time, then as written.
   function Comes_Before (Left, Right : Faults.Fault) return Boolean is
     (Left.Time < Right.Time
      or else (Left.Time = Right.Time and then Left.Line < Right.Line));

   package Sorting is new Fault_Vectors.Generic_Sorting (Comes_Before);

   --  Sets the times that Transmit looks at first.
   procedure Set_Next_Time (Carrier : in out One_Way);
   procedure Set_Next_Silence (Over : in out Line; Way : Direction);

   --  Adds a silence that begins no earlier than those added before.
   procedure Add_Silence (Over : in out Line; Added : Silence);

   --  Gives each fault whose time has come the character it is for.
   procedure Make_Due (Carrier : in out One_Way; Time : Microseconds);

   --  What the character is in for that is being sent.
   procedure Take_Due (Carrier : in out One_Way; Meant : out Effect);

   function Has_Odd_Ones (Mask : Faults.Character_Bits) return Boolean;

   procedure Set_Next_Time (Carrier : in out One_Way) is
   begin
      Carrier.Next_Time :=
        (if Carrier.Next <= Carrier.Waiting.Last_Index
         then Carrier.Waiting (Carrier.Next).Time
         else Never);
   end Set_Next_Time;

   procedure Set_Next_Silence (Over : in out Line; Way : Direction) is
      Carrier : One_Way renames Over.Ways (Way);
   begin
      Carrier.Next_Silence :=
        (if Carrier.Silence_Index <= Over.Silences.Last_Index
         then Over.Silences (Carrier.Silence_Index)
         else (Never, Never));
   end Set_Next_Silence;

   procedure Add_Silence (Over : in out Line; Added : Silence) is
      Last : constant Natural := Over.Silences.Last_Index;
   begin
      if Added.First = Added.Stop then
         return;
      elsif Last > 0 and then Added.First <= Over.Silences (Last).Stop then
         Over.Silences (Last).Stop :=
           Microseconds'Max (Over.Silences (Last).Stop, Added.Stop);
      else
         Over.Silences.Append (Added);
      end if;
   end Add_Silence;

   procedure Prepare (Made : in out Line; Script : Faults.Script) is
      Cuts : Fault_Vectors.Vector;
   begin
      Made.Silences.Clear;
      Made.Ways := (others => <>);

      for Index in 1 .. Faults.Length (Script) loop
         declare
            Next : constant Faults.Fault := Faults.Element (Script, Index);
         begin
            case Next.Kind is
               when Faults.Cut =>
                  Cuts.Append (Next);
               when Faults.Flip | Faults.Drop =>
                  Made.Ways (Next.Way).Waiting.Append (Next);
               when Faults.Bit_Errors | Faults.Duplicate | Faults.Insert =>
                  --  Not supported yet, and refused when read.
                  raise Program_Error;
               when Faults.Stall | Faults.Reset =>
                  --  Not of the line.
                  null;
            end case;
         end;
      end loop;

      Sorting.Sort (Cuts);
      for Cut of Cuts loop
         Add_Silence (Made, (Cut.Time, Cut.Time + Cut.Duration));
      end loop;

      for Way in Direction loop
         Sorting.Sort (Made.Ways (Way).Waiting);
         Set_Next_Time (Made.Ways (Way));
         Set_Next_Silence (Made, Way);
      end loop;
   end Prepare;

   procedure Make_Due (Carrier : in out One_Way; Time : Microseconds) is
   begin
      while Carrier.Next_Time <= Time loop
         declare
            Fault  : constant Faults.Fault :=
              Carrier.Waiting (Carrier.Next);

            --  The character being sent now is the first of those after
            --  the fault's time, and is counted already.
            Number : constant Character_Number :=
              Carrier.Sent - 1 + Character_Number (Fault.Ordinal);

            Meant  : Effect;
         begin
            if Carrier.Due.Contains (Number) then
               Meant := Carrier.Due (Number);
            end if;
            if Fault.Kind in Faults.Flip then
               Meant.Mask := Meant.Mask xor Fault.Mask;
            else
               Meant.Is_Lost := True;
            end if;
            Carrier.Due.Include (Number, Meant);
         end;
         Carrier.Next := Carrier.Next + 1;
         Set_Next_Time (Carrier);
      end loop;
      Carrier.Next_Due := Carrier.Due.First_Key;
   end Make_Due;

   procedure Take_Due (Carrier : in out One_Way; Meant : out Effect) is
   begin
      Meant := Carrier.Due.First_Element;
      Carrier.Due.Delete_First;
      Carrier.Next_Due :=
        (if Carrier.Due.Is_Empty
         then Character_Number'Last
         else Carrier.Due.First_Key);
   end Take_Due;

   function Has_Odd_Ones (Mask : Faults.Character_Bits) return Boolean is
      Rest : Faults.Character_Bits := Mask;
      Odd  : Boolean := False;
   begin
      while Rest /= 0 loop
         Odd  := not Odd;
         Rest := Rest and (Rest - 1);
      end loop;
      return Odd;
   end Has_Odd_Ones;

   procedure Transmit
     (Over     : in out Line;
      Way      : Direction;
      Time     : Microseconds;
      Data     : Byte;
      Count    : out Arrival_Count;
      Arriving : out Arrival_List)
   is
      Carrier : One_Way renames Over.Ways (Way);
      Meant   : Effect;
   begin
      Carrier.Sent := Carrier.Sent + 1;
      Count        := 1;
      Arriving (1) := (Data, Parity_Error => False);

      if Carrier.Next_Time <= Time then
         Make_Due (Carrier, Time);
      end if;
      if Carrier.Next_Due = Carrier.Sent then
         Take_Due (Carrier, Meant);
         if Meant.Is_Lost then
            Count := 0;
         else
            Arriving (1) :=
              (Data xor Byte (Meant.Mask mod Parity_Bit),
               Parity_Error => Has_Odd_Ones (Meant.Mask));
         end if;
      end if;

      --  A character of which any part falls into a silence is lost.
      while Carrier.Next_Silence.Stop <= Time loop
         Carrier.Silence_Index := Carrier.Silence_Index + 1;
         Set_Next_Silence (Over, Way);
      end loop;
      if Carrier.Next_Silence.First < Time + Character_Time then
         Count := 0;
      end if;
   end Transmit;

end Sim.Faulty_Line;
