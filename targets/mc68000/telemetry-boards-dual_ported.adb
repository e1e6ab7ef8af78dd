--  SPDX-License-Identifier: Apache-2.0

with Interfaces;          use Interfaces;
with System.Machine_Code; use System.Machine_Code;

package body Telemetry.Boards.Dual_Ported is

   --  The memory

   Ready : Unsigned_32
   with Volatile, Import, Convention => C, External_Name => "urv_board_ready";

   Lock : Unsigned_8
   with Volatile, Import, Convention => C, External_Name => "urv_board_lock";

   News : Unsigned_8
   with Volatile, Import, Convention => C, External_Name => "urv_board_news";

   Shared : Board
   with Import, Convention => C, External_Name => "urv_shared_board";

   Memory_Is_Ready : constant Unsigned_32 := 16#4455_414C#;   --  "DUAL"

   --  The processor's own variables

   --  It has claimed the lock, or is about to.
   Is_Claiming : Boolean := False with Volatile;

   --  The tries of a claim: more than 20,000 cycles, the longest operation has
   --  fewer. There is one only while the other processor seems to have failed.
   Most_Tries : constant := 500;

   type Try_Count is range 1 .. Most_Tries with Size => 16;

   Tries : Try_Count := Most_Tries;

   --  The controller's operations that wait for a claim, and its last results

   Must_Clear   : Boolean := False;
   Must_Discard : Boolean := False;

   Last_Ever  : Boolean    := False;
   Last_Tally : Statistics := (others => <>);

   --  Waits for the lock. Claimed is False if the wait was too long.
   procedure Claim (Claimed : out Boolean)
   with Inline;

   procedure Go_On_Trying (Claimed : out Boolean);
   pragma No_Inline (Go_On_Trying);

   procedure Release
   with Inline;

   --  A claim by the controller, which makes up for what it has left out.
   procedure Claim_By_Controller (Claimed : out Boolean);

   procedure Clear;

   procedure Discard;

   --  One TAS. The compiler moves no access to memory across it.
   function Is_Taken_By_Other return Boolean
   with Inline;

   function Is_Taken_By_Other return Boolean is
      Was_Free : Unsigned_8;
   begin
      Asm ("tas %1" & ASCII.LF & ASCII.HT & "seq %0",
           Outputs  => (Unsigned_8'Asm_Output ("=&d", Was_Free),
                        Unsigned_8'Asm_Output ("=m", Lock)),
           Clobber  => "memory",
           Volatile => True);
      return Was_Free = 0;
   end Is_Taken_By_Other;

   procedure Claim (Claimed : out Boolean) is
   begin
      Is_Claiming := True;
      if not Is_Taken_By_Other then
         Tries := Most_Tries;
         Claimed := True;
      else
         Go_On_Trying (Claimed);
      end if;
   end Claim;

   procedure Go_On_Trying (Claimed : out Boolean) is
   begin
      for Try in 2 .. Tries loop
         Claimed := not Is_Taken_By_Other;
         if Claimed then
            Tries := Most_Tries;
            return;
         end if;
      end loop;
      Is_Claiming := False;
      Tries := 1;
      Claimed := False;
   end Go_On_Trying;

   procedure Release is
   begin
      Asm ("move.b #0, %0",
           Outputs  => Unsigned_8'Asm_Output ("=m", Lock),
           Clobber  => "memory",
           Volatile => True);
      Is_Claiming := False;
   end Release;

   procedure Clear is
   begin
      Clear_Transmit_Half (Shared);
      News := 1;
      Must_Clear := False;
   end Clear;

   procedure Discard is
      Unused_Data          : Block_Data;
      Unused_Fresh         : Boolean;
      Unused_Ever_Received : Boolean;
   begin
      Take (Shared, Unused_Data, Unused_Fresh, Unused_Ever_Received);
      Must_Discard := False;
   end Discard;

   procedure Claim_By_Controller (Claimed : out Boolean) is
   begin
      Claim (Claimed);
      if Claimed and then (Must_Clear or else Must_Discard) then
         if Must_Clear then
            Clear;
         end if;
         if Must_Discard then
            Discard;
         end if;
      end if;
   end Claim_By_Controller;

   procedure Initialise (First : Board; Time : Round_Trip_Time) is
      Unused_Claimed : Boolean;
   begin
      Claim (Unused_Claimed);
      Shared := First;
      Set_Round_Trip (Shared, Time);
      News := 0;
      Release;
   end Initialise;

   procedure Make_Ready is
   begin
      Ready := Memory_Is_Ready;
   end Make_Ready;

   function Is_Ready return Boolean is (Ready = Memory_Is_Ready);

   function Is_Taken return Boolean is (Ready = 0);

   procedure Recover is
      Before  : Turns.Control renames Shared.Control;
      Claimed : Boolean;
   begin
      if not Is_Claiming then
         return;
      end if;
      Tries := Most_Tries;
      Claim (Claimed);
      if not Claimed then
         --  The claim is the one of this processor from before its restart.
         --  The constants of the board and each of its counts are whole. The
         --  rest may not be.
         Is_Claiming := True;
         Shared :=
           (Control       =>
              (Role            => Before.Role,
               Transmit_Length => Before.Transmit_Length,
               Receive_Length  => Before.Receive_Length,
               Round_Trip      => Before.Round_Trip,
               Tally           => Before.Tally,
               others          => <>),
            Receive_Pair  => Empty_Pair,
            Transmit_Pair => Empty_Pair);
         Start (Shared);
         Tries := Most_Tries;
      end if;
      Release;
   end Recover;

   procedure Take
     (Data          : out Block_Data;
      Fresh         : out Boolean;
      Ever_Received : out Boolean)
   is
      Claimed : Boolean;
   begin
      Claim_By_Controller (Claimed);
      if Claimed then
         Take (Shared, Data, Fresh, Last_Ever);
         Release;
      else
         Data := (others => 0);
         Fresh := False;
      end if;
      Ever_Received := Last_Ever;
   end Take;

   procedure Put (Data : Block_Data; Overwrote : out Boolean) is
      Claimed : Boolean;
   begin
      Claim_By_Controller (Claimed);
      if Claimed then
         Put (Shared, Data, Overwrote);
         News := 1;
         Release;
      else
         Overwrote := True;
      end if;
   end Put;

   procedure Clear_Transmit_Half is
      Claimed : Boolean;
   begin
      Must_Clear := True;
      Claim_By_Controller (Claimed);
      if Claimed then
         Release;
      end if;
   end Clear_Transmit_Half;

   procedure Discard_Received is
      Claimed : Boolean;
   begin
      Must_Discard := True;
      Claim_By_Controller (Claimed);
      if Claimed then
         Release;
      end if;
   end Discard_Received;

   function Has_Received return Boolean is
      Claimed : Boolean;
   begin
      Claim_By_Controller (Claimed);
      if not Claimed then
         return False;
      end if;
      return Found : constant Boolean := Any_Full (Shared.Receive_Pair) do
         Release;
      end return;
   end Has_Received;

   function Tally return Statistics is
      Claimed : Boolean;
   begin
      Claim_By_Controller (Claimed);
      if Claimed then
         Last_Tally := Tally (Shared);
         Release;
      end if;
      return Last_Tally;
   end Tally;

   procedure Start is
      Claimed : Boolean;
   begin
      Claim (Claimed);
      if Claimed then
         Start (Shared);
         Release;
      end if;
   end Start;

   function Has_News return Boolean is (News /= 0);

   procedure Accept_Character
     (Elapsed      : Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      May_Speak    : out Boolean)
   is
      Claimed : Boolean;
   begin
      Claim (Claimed);
      if Claimed then
         Elapse (Shared, Elapsed);
         Accept_Character (Shared, Data, Parity_Error);
         May_Speak := Boards.May_Speak (Shared);
         Release;
      else
         May_Speak := False;
      end if;
   end Accept_Character;

   procedure Next_Character
     (Elapsed   : Character_Times;
      Send      : out Boolean;
      Data      : out Byte;
      Time_Left : out Character_Times)
   is
      Claimed : Boolean;
   begin
      Claim (Claimed);
      if Claimed then
         News := 0;
         Elapse (Shared, Elapsed);
         Next_Character (Shared, Send, Data);
         Time_Left := Boards.Time_Left (Shared);
         Release;
      else
         Send := False;
         Data := 0;
         Time_Left := 1;
      end if;
   end Next_Character;

end Telemetry.Boards.Dual_Ported;
