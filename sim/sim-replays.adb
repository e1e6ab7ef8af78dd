--  SPDX-License-Identifier: Apache-2.0

package body Sim.Replays is

   --  The length of an uplink or a downlink.
   function Length_Of (Header : Byte) return Natural is
     (case Header is
         when 16#1E# => Telemetry.Uplink_Length + 2,
         when 16#87# => Telemetry.Downlink_Length + 2,
         when others => 0);

   --  An unfinished message is over after a silence of this length.
   Silence : constant := 4 * Character_Time;

   --  The message that replaces the last one of Sent.
   procedure Choose (Through : in out Middle; Time : Microseconds);

   procedure Prepare
     (Made : in out Middle; Given : Faults.Fault_List) is
   begin
      Made.Given := Given;
      Made.Next  := 1;
      Made.Sent.Clear;
      Made.Left  := 0;
      Made.Shown := 0;
   end Prepare;

   procedure Choose (Through : in out Middle; Time : Microseconds) is
   begin
      while Through.Next <= Through.Given.Last_Index
        and then Through.Given (Through.Next).Time <= Time
      loop
         Through.Next := Through.Next + 1;
      end loop;

      Through.Shown := 0;
      if Through.Next > 1 then
         declare
            Replay : constant Faults.Fault :=
              Through.Given (Through.Next - 1);
            Back   : constant Positive := Positive (Replay.Ordinal);
         begin
            if Time < Replay.Time + Replay.Duration
              and then Back < Through.Sent.Last_Index
            then
               Through.Shown := Through.Sent.Last_Index - Back;
            end if;
         end;
      end if;
   end Choose;

   procedure Replace
     (Through : in out Middle;
      Time    : Microseconds;
      Data    : in out Byte)
   is
      Length : Natural;
      Place  : Positive;
   begin
      if Through.Given.Is_Empty then
         return;
      end if;

      if Through.Left = 0 or else Time > Through.Last + Silence then
         Length := Length_Of (Data);
         Through.Left := Length;
         if Length > 0 then
            Through.Sent.Append (Message'(Length => Length, others => <>));
            Choose (Through, Time);
         end if;
      end if;
      Through.Last := Time;

      if Through.Left > 0 then
         Length := Through.Sent.Last_Element.Length;
         Place  := Length - Through.Left + 1;
         Through.Sent (Through.Sent.Last_Index).Content (Place) := Data;
         Through.Left := Through.Left - 1;
         if Through.Shown > 0 then
            Data := Through.Sent (Through.Shown).Content (Place);
         end if;
      end if;
   end Replace;

end Sim.Replays;
