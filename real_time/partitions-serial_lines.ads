--  A serial device as the link: 125 kbaud, 8 data bits, even parity, 2 stop
--  bits (D-4). A pseudo-terminal is one too.

with Partitions.System_Calls;
with URVOS; use URVOS;

package Partitions.Serial_Lines is

   --  The device, set and locked for this process. Raises Sim.Bad_Input.
   function Opened (Device : String) return System_Calls.File;

   --  The operating system marks a character that was received with an
   --  error by FF 00 before it, and doubles an FF that was not.
   type Mark_Reader is limited private;

   --  The device has given one more byte. Found tells that it completes a
   --  character, which then is in Data.
   procedure Take
     (Reader       : in out Mark_Reader;
      Data         : Byte;
      Found        : out Boolean;
      Parity_Error : out Boolean);

private

   type Place is (At_Character, After_Mark, At_Damaged);

   type Mark_Reader is limited record
      Now_At : Place := At_Character;
   end record;

end Partitions.Serial_Lines;
