--  SPDX-License-Identifier: Apache-2.0

package body Host.File_States is

   function Get_State
     (Folder : int;
      Path   : char_array;
      Flags  : int;
      Wanted : unsigned;
      Result : out State) return int
   with Import, Convention => C, External_Name => "statx";

   Of_Descriptor  : constant := 16#1000#;
   Working_Folder : constant := -100;

   --  Kind, mode, owner and inode; the device always comes.
   Wanted_Fields : constant := 16#10B#;

   procedure Read (File : int; Found : out Boolean; Result : out State) is
   begin
      Found :=
        Get_State (File, To_C (""), Of_Descriptor, Wanted_Fields, Result) = 0;
   end Read;

   procedure Read (Name : String; Found : out Boolean; Result : out State) is
   begin
      Found :=
        Get_State (Working_Folder, To_C (Name), 0, Wanted_Fields, Result) = 0;
   end Read;

end Host.File_States;
