--  URVOS, the operating system of both nodes (report, section 3).
--
--  This package holds the machine's two units of data and the counter that
--  every error count uses. The kernel knows nothing of the vehicle.

with Interfaces;

package URVOS with Pure, SPARK_Mode is

   --  What the serial link carries.
   type Byte is new Interfaces.Unsigned_8;

   --  What the boards and the buffers hold (BUF-3).
   type Word is new Interfaces.Unsigned_16;

   --  How often something happened. A count that reaches its last value
   --  stays there: "at least that often".
   type Count is range 0 .. 2 ** 31 - 1;

   function Incremented (Value : Count) return Count is
     (if Value = Count'Last then Value else Value + 1)
   with Global => null;

   --  Two counts together.
   function Saturating_Sum (Left, Right : Count) return Count is
     (if Left > Count'Last - Right then Count'Last else Left + Right)
   with Global => null;

end URVOS;
