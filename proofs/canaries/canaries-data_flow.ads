--  SPDX-License-Identifier: Apache-2.0

--  False claims about inputs, outputs and dependencies of subprograms, and
--  about the state of a package.

with URVOS; use URVOS;

package Canaries.Data_Flow
  with
    SPARK_Mode,
    Abstract_State => Memory,
    Initializes    => Memory
is

   --  Reads nothing if nothing is wanted; Value then has no value.
   procedure Read (Wanted : Boolean; Value : out Word)
   with Global => (Input => Memory);

   --  A look that changes the memory.
   procedure Peek (Value : out Word)
   with Global => (Input => Memory);  --  GLOBAL_MISSING

   --  The higher of two words depends on both.
   procedure Sort (Left, Right : Word; Low, High : out Word)
   with
     Global  => null,
     Depends => (Low => (Left, Right), High => Right);  --  DEPENDS_MISSING

   --  The first of two sums depends on one word alone.
   procedure Add_Up (Left, Right : Word; First, Last : out Word)
   with
     Global  => null,
     Depends => ((First, Last) => (Left, Right));  --  DEPENDS_WRONG

   type Row is array (Byte) of Word;

   --  Two places may be the same.
   procedure Swap (Left, Right : in out Word)
   with Global => null;

   procedure Exchange (Words : in out Row; From, To : Byte)
   with
     Global => null,
     Pre    => From <= To;

   function Is_Empty return Boolean
   with Global => Memory;

   --  The body hides that zero leaves it empty.
   procedure Fill (Value : Word)
   with
     Global => (In_Out => Memory),
     Post   => not Is_Empty;

end Canaries.Data_Flow;
