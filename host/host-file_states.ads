--  SPDX-License-Identifier: Apache-2.0

--  The state of a file, as the operating system (Linux) reports it.

with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;

private package Host.File_States is

   --  struct statx, up to the device; then room for all that the system
   --  writes.
   type Times is array (1 .. 8) of Unsigned_64;
   type Rest_Of_State is array (1 .. 28) of Unsigned_32;

   type State is record
      Mask         : Unsigned_32 := 0;
      Block_Size   : Unsigned_32 := 0;
      Attributes   : Unsigned_64 := 0;
      Links        : Unsigned_32 := 0;
      User         : Unsigned_32 := 0;
      Group        : Unsigned_32 := 0;
      Mode         : Unsigned_16 := 0;
      Spare        : Unsigned_16 := 0;
      Inode        : Unsigned_64 := 0;
      Size         : Unsigned_64 := 0;
      Blocks       : Unsigned_64 := 0;
      Known        : Unsigned_64 := 0;
      Changed      : Times       := (others => 0);
      Own_Major    : Unsigned_32 := 0;
      Own_Minor    : Unsigned_32 := 0;
      Device_Major : Unsigned_32 := 0;
      Device_Minor : Unsigned_32 := 0;
      Rest         : Rest_Of_State := (others => 0);
   end record with Convention => C;

   State_Bits : constant := 256 * 8;
   pragma Compile_Time_Error
     (State'Size /= State_Bits, "not as long as struct statx");

   --  The bits of Mode that are the kind of the file, and a regular one.
   Kind_Bits : constant := 8#170_000#;
   Regular   : constant := 8#100_000#;

   --  The state of the open file. Found is False when the system refuses it.
   procedure Read (File : int; Found : out Boolean; Result : out State);

   --  The same of the file with that name, after symbolic links.
   procedure Read (Name : String; Found : out Boolean; Result : out State);

   function Is_Regular (Item : State) return Boolean is
     ((Item.Mode and Kind_Bits) = Regular);

   --  True if both are one file: its names may be hard links.
   function Is_One_File (Left, Right : State) return Boolean is
     (Left.Inode = Right.Inode
      and then Left.Device_Major = Right.Device_Major
      and then Left.Device_Minor = Right.Device_Minor);

end Host.File_States;
