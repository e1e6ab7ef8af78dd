--  SPDX-License-Identifier: Apache-2.0

with Last_Chance;
pragma Unreferenced (Last_Chance);
with Machine_Needs;
pragma Unreferenced (Machine_Needs);
with System.Storage_Elements;      use System.Storage_Elements;
with Telemetry;                    use Telemetry;
with Telemetry.Boards.Dual_Ported; use Telemetry.Boards.Dual_Ported;
with URVOS;                        use URVOS;

package body Exploration_Program is

   --  An order, or 0. The bytes from the lowest: operation, time, data, error.
   Order : Unsigned_32
   with Volatile, Import, Address => To_Address (16#F3_0010#);

   Result : Unsigned_32
   with Volatile, Import, Address => To_Address (16#F3_0014#);

   --  Blocks of four equal bytes

   Length : constant := 4;

   procedure Execute (Item : Unsigned_32);

   procedure Report (Value : Boolean);

   procedure Report (Value : Count);

   procedure Report (Value : Boolean) is
   begin
      Result := (if Value then 1 else 0);
   end Report;

   procedure Report (Value : Count) is
   begin
      Result := Unsigned_32 (Value);
   end Report;

   procedure Execute (Item : Unsigned_32) is
      Time : constant Character_Times :=
        Character_Times (Shift_Right (Item, 8) and 255);
      Data : constant Byte := Byte (Shift_Right (Item, 16) and 255);
      Block                       : Block_Data := (others => 0);
      Overwrote, Fresh, Ever, Yes : Boolean;
      Character                   : Byte;
      Time_Left                   : Character_Times;
   begin
      case Item and 255 is
         when 1 =>
            Initialise
              (Boards.New_Board
                 ((if Data = 0 then Ground else Aircraft), Length, Length),
               0);
            Make_Ready;
         when 2 =>
            Block (1 .. Length) := (others => Data);
            Put (Block, Overwrote);
            Report (Overwrote);
         when 3 =>
            Take (Block, Fresh, Ever);
            Report (Fresh);
            Report (Ever);
            for Each of Block (1 .. Length) loop
               Report (Count (Each));
            end loop;
         when 4 => Discard_Received;
         when 5 => Clear_Transmit_Half;
         when 6 => Report (Has_Received);
         when 7 =>
            declare
               Counts : constant Statistics := Tally;
            begin
               Report (Counts.Sent);
               Report (Counts.Received);
               Report (Counts.Bad);
               Report (Counts.Scrapped);
               Report (Counts.Cleared);
               Report (Counts.Resets);
               Report (Counts.Not_Taken);
            end;
         when 8 =>
            Accept_Character (Time, Data, Item >= 2 ** 24, Yes);
            Report (Yes);
         when 9 =>
            Next_Character (Time, Yes, Character, Time_Left);
            Report (Yes);
            Report (Count (Character));
            Report (Count (Time_Left));
         when 10 => Start;
         when others => null;
      end case;
   end Execute;

   procedure Run is
      Item : Unsigned_32;
   begin
      loop
         Item := Order;
         if Item /= 0 then
            Execute (Item);
         end if;
      end loop;
   end Run;

   procedure Restart (Condition : Integer_32) is
      pragma Unreferenced (Condition);
   begin
      Result := Unsigned_32'Last;
   end Restart;

end Exploration_Program;
