--  SPDX-License-Identifier: Apache-2.0

--  Does to a telemetry board what the bytes on standard input say. Every
--  contract is executed: a violated one, or any exception, aborts.
--
--  The first byte chooses the board; then each byte is something that
--  happens, some with a byte that says more.

with Ada.Exceptions;
with Ada.Text_IO;
with Interfaces.C;
with Telemetry;         use Telemetry;
with Telemetry.Boards;  use Telemetry.Boards;
with Telemetry.Headers; use Telemetry.Headers;
with URVOS;             use URVOS;

procedure URV_Fuzz is

   use type Interfaces.C.int;

   Room : constant := 4096;
   type Bytes is array (1 .. Room) of Byte with Convention => C;

   function Next_Input
     (Input : out Bytes; Size : Interfaces.C.int) return Interfaces.C.int
   with Import, Convention => C, External_Name => "urv_next_input";

   procedure Crash
   with Import, Convention => C, External_Name => "urv_crash", No_Return;

   type Happening is
     (Character,         --  with the byte that says what comes
      Wrong_Parity,      --  the same, with a parity error
      Right_Sum,         --  the checksum that would be right comes
      Header,            --  one of the ten first bytes comes
      Time_Passes,       --  with the byte that says how long
      Poll,
      Put,               --  with the byte that the block is made of
      Take,
      Restart);          --  the board, its controller, or both

   --  Does to a board all that the input says.
   procedure Play
     (Item   : in out Board;
      Input  : Bytes;
      Length : Natural);

   procedure Play
     (Item   : in out Board;
      Input  : Bytes;
      Length : Natural)
   is
      Headers : constant array (Byte range 0 .. 9) of Byte :=
        (16#1E#, 16#2D#, 16#33#, 16#4B#, 16#55#,
         16#87#, 16#99#, 16#B4#, 16#CC#, 16#D2#);
      Place   : Positive := 2;
      What    : Happening;
      Send    : Boolean;
      Told    : Boolean;
      Data    : Byte;
      Block   : Block_Data;

      --  The next byte of the input; 0 after its end.
      procedure Read (Value : out Byte);

      procedure Read (Value : out Byte) is
      begin
         Value := (if Place <= Length then Input (Place) else 0);
         Place := Place + 1;
      end Read;
   begin
      while Place <= Length loop
         Read (Data);
         What := Happening'Val
           (Natural (Data) mod (Happening'Pos (Happening'Last) + 1));
         case What is
            when Character | Wrong_Parity =>
               Read (Data);
               Accept_Character (Item, Data, What = Wrong_Parity);
            when Right_Sum                =>
               Accept_Character
                 (Item, Control_Of (Item).Receiver.Sum, False);
            when Header                   =>
               Read (Data);
               Accept_Character (Item, Headers (Data mod 10), False);
            when Time_Passes              =>
               Read (Data);
               Elapse (Item, Character_Times (Data));
            when Poll                     =>
               Next_Character (Item, Send, Data);
            when Put                      =>
               Read (Data);
               Put (Item, (others => Data), Told);
            when Take                     =>
               Take (Item, Block, Send, Told);
            when Restart                  =>
               Read (Data);
               if Data mod 3 /= 0 then
                  Start (Item);
               end if;
               if Data mod 3 /= 1 then
                  Clear_Transmit_Half (Item);
               end if;
         end case;
      end loop;
   end Play;

   Input  : Bytes;
   Length : Interfaces.C.int;
begin
   loop
      Length := Next_Input (Input, Room);
      exit when Length < 0;
      if Length > 0 then
         declare
            Choice : constant Natural := Natural (Input (1) mod 6);
            Role   : constant Station :=
              (if Choice mod 2 = 0 then Ground else Aircraft);
            Up     : constant Block_Length :=
              (case Choice / 2 is when 0 => 1, when 1 => 4, when others => 28);
            Down   : constant Block_Length :=
              (case Choice / 2 is when 0 => 1, when 1 => 2, when others => 56);
            Item   : Board := New_Board
              (Role            => Role,
               Transmit_Length => (if Role = Ground then Up else Down),
               Receive_Length  => (if Role = Ground then Down else Up));
         begin
            Play (Item, Input, Natural (Length));
         end;
      end if;
   end loop;
exception
   when Found : others =>
      Ada.Text_IO.Put_Line
        (Ada.Text_IO.Standard_Error,
         Ada.Exceptions.Exception_Information (Found));
      Crash;
end URV_Fuzz;
