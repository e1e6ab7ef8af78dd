--  SPDX-License-Identifier: Apache-2.0

package body Sim.Faulty_Line is

   use type Faults.Character_Bits;

   Parity_Bit : constant Faults.Character_Bits := 2 ** 8;

   --  Sets the times that Transmit looks at first.
   procedure Set_Next_Time (Carrier : in out One_Path);
   procedure Set_Next_Noise (Carrier : in out One_Path);

   --  Combines a fault with the other effects on its character.
   procedure Join (Meant : in out Effect; Fault : Faults.Fault);

   --  Assigns a character to each fault whose time has come.
   procedure Make_Due (Carrier : in out One_Path; Time : Microseconds);

   --  The effect on the character being sent.
   procedure Take_Due (Carrier : in out One_Path; Meant : out Effect);

   --  Bits of the character being sent that flip by chance.
   procedure Make_Noise
     (Carrier : in out One_Path;
      Time    : Microseconds;
      Mask    : in out Faults.Character_Bits);

   --  True if a fault may affect the character being sent.
   function Is_Disturbed
     (Carrier : One_Path; Time : Microseconds) return Boolean
   is
     (Carrier.Next_Time <= Time
      or else Carrier.Next_Due = Carrier.Sent
      or else Carrier.Next_Noise <= Time
      or else Windows.Next (Carrier.Silences).First < Time + Character_Time);

   --  Applies that effect.
   procedure Disturb
     (Carrier : in out One_Path;
      Time    : Microseconds;
      Heard   : in out Delivery)
   with No_Inline;

   function Has_Odd_Ones (Mask : Faults.Character_Bits) return Boolean;

   procedure Append (To : in out Arrival_List; Added : Arrival) is
   begin
      if To.Length < Most_Arrivals then
         To.Length := To.Length + 1;
         To.Items (To.Length) := Added;
      end if;
   end Append;

   procedure Append (To : in out Arrival_List; Added : Arrival_List) is
   begin
      for Index in 1 .. Added.Length loop
         Append (To, Added.Items (Index));
      end loop;
   end Append;

   procedure Set_Next_Time (Carrier : in out One_Path) is
   begin
      Carrier.Next_Time :=
        (if Carrier.Next <= Carrier.Waiting.Last_Index
         then Carrier.Waiting (Carrier.Next).Time
         else Never);
   end Set_Next_Time;

   procedure Set_Next_Noise (Carrier : in out One_Path) is
   begin
      Carrier.Next_Noise :=
        (if not Carrier.Active_Noises.Is_Empty
         then 0
         elsif Carrier.Noise_Index <= Carrier.Noises.Last_Index
         then Carrier.Noises (Carrier.Noise_Index).Time
         else Never);
   end Set_Next_Noise;

   procedure Prepare
     (Made   : in out Line;
      Script : Faults.Script;
      Seed   : Seed_Number) is
   begin
      Made.Paths := (others => <>);

      for Path in Direction loop
         Made.Paths (Path).Waiting  := Faults.Of_Characters (Script, Path);
         Made.Paths (Path).Noises   := Faults.Noises (Script, Path);
         Replays.Prepare
           (Made.Middles (Path), Faults.Replays (Script, Path));
         Made.Paths (Path).Silences := Faults.Cuts (Script);
         Set_Next_Time (Made.Paths (Path));
         Set_Next_Noise (Made.Paths (Path));
         Made.Paths (Path).Chance := Noise.Seeded (Seed, Path);
      end loop;
   end Prepare;

   procedure Join (Meant : in out Effect; Fault : Faults.Fault) is
   begin
      case Faults.Character_Fault'(Fault.Kind) is
         when Faults.Flip =>
            Meant.Mask := Meant.Mask xor Fault.Mask;
         when Faults.Drop =>
            Meant.Is_Lost := True;
         when Faults.Insert =>
            Append
              (Meant.Inserted,
               Arrival'(Fault.Inserted, Parity_Error => False));
         when Faults.Duplicate =>
            if Meant.Copies < Most_Arrivals then
               Meant.Copies := Meant.Copies + 1;
            end if;
      end case;
   end Join;

   procedure Make_Due (Carrier : in out One_Path; Time : Microseconds) is
   begin
      while Carrier.Next_Time <= Time loop
         declare
            Fault  : constant Faults.Fault :=
              Carrier.Waiting (Carrier.Next);

            --  The character being sent is the first one after the fault's
            --  time, and is counted already.
            Number : constant Character_Number :=
              Carrier.Sent - 1 + Character_Number (Fault.Ordinal);

            Meant  : Effect;
         begin
            if Carrier.Due.Contains (Number) then
               Meant := Carrier.Due (Number);
            end if;
            Join (Meant, Fault);
            Carrier.Due.Include (Number, Meant);
         end;
         Carrier.Next := Carrier.Next + 1;
         Set_Next_Time (Carrier);
      end loop;
      Carrier.Next_Due := Carrier.Due.First_Key;
   end Make_Due;

   procedure Take_Due (Carrier : in out One_Path; Meant : out Effect) is
   begin
      Meant := Carrier.Due.First_Element;
      Carrier.Due.Delete_First;
      Carrier.Next_Due :=
        (if Carrier.Due.Is_Empty
         then Character_Number'Last
         else Carrier.Due.First_Key);
   end Take_Due;

   procedure Make_Noise
     (Carrier : in out One_Path;
      Time    : Microseconds;
      Mask    : in out Faults.Character_Bits)
   is
      Drawn : Faults.Character_Bits;
   begin
      while Carrier.Noise_Index <= Carrier.Noises.Last_Index
        and then Carrier.Noises (Carrier.Noise_Index).Time <= Time
      loop
         declare
            Begun : constant Faults.Fault :=
              Carrier.Noises (Carrier.Noise_Index);
         begin
            Carrier.Active_Noises.Append
              (Noise_Spell'
                 (Stop  => Begun.Time + Begun.Duration,
                  Level => Noise.To_Level (Begun.Rate)));
         end;
         Carrier.Noise_Index := Carrier.Noise_Index + 1;
      end loop;

      for Index in reverse 1 .. Carrier.Active_Noises.Last_Index loop
         if Carrier.Active_Noises (Index).Stop <= Time then
            Carrier.Active_Noises.Delete (Index);
         else
            Noise.Draw
              (Carrier.Chance, Carrier.Active_Noises (Index).Level, Drawn);
            Mask := Mask xor Drawn;
         end if;
      end loop;
      Set_Next_Noise (Carrier);
   end Make_Noise;

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

   procedure Disturb
     (Carrier : in out One_Path;
      Time    : Microseconds;
      Heard   : in out Delivery)
   is
      Meant : Effect;
   begin
      if Carrier.Next_Time <= Time then
         Make_Due (Carrier, Time);
      end if;
      if Carrier.Next_Due = Carrier.Sent then
         Take_Due (Carrier, Meant);
      end if;
      if Carrier.Next_Noise <= Time then
         Make_Noise (Carrier, Time, Meant.Mask);
      end if;

      --  A character of which any part falls into a silence is lost.
      while Windows.Next (Carrier.Silences).Stop <= Time loop
         Windows.Skip (Carrier.Silences);
      end loop;
      if Meant.Is_Lost
        or else Windows.Next (Carrier.Silences).First < Time + Character_Time
      then
         Heard.Is_Lost := True;
         return;
      end if;

      if Meant.Mask /= 0 then
         Heard.Itself :=
           (Heard.Itself.Data xor Byte (Meant.Mask mod Parity_Bit),
            Parity_Error => Has_Odd_Ones (Meant.Mask));
      end if;
      if Meant.Inserted.Length > 0 then
         Append (Heard.Before, Meant.Inserted);
      end if;
      for Copy in 1 .. Meant.Copies loop
         Append (Heard.After, Heard.Itself);
      end loop;
   end Disturb;

   procedure Transmit
     (Over     : in out Line;
      Path     : Direction;
      Time     : Microseconds;
      Data     : Byte;
      Heard    : out Delivery)
   is
      Carrier : One_Path renames Over.Paths (Path);
      Passed  : Byte := Data;
   begin
      Carrier.Sent := Carrier.Sent + 1;
      Replays.Replace (Over.Middles (Path), Time, Passed);

      Heard.Before.Length := 0;
      Heard.After.Length  := 0;
      Heard.Is_Lost       := False;
      Heard.Itself        := (Passed, Parity_Error => False);

      if Is_Disturbed (Carrier, Time) then
         Disturb (Carrier, Time, Heard);
      end if;
   end Transmit;

end Sim.Faulty_Line;
