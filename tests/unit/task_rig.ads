--  SPDX-License-Identifier: Apache-2.0

--  A common basis for tests of the tasks: recognisable messages, the other
--  ends of the variables, and the tasks' reports.

with URVOS;         use URVOS;
with URV.Buffers;   use URV.Buffers;
with URV.Errors;    use URV.Errors;
with URV.Mailboxes; use URV.Mailboxes;
with URV.Shared_Errors;
with Variable_Ends;

package Task_Rig is

   package Words is new Variable_Ends (For_Sensor_Words);
   package Images is new Variable_Ends (For_Sensor_Images);
   package Stick_Images is new Variable_Ends (For_Stick_Images);
   package Up is new Variable_Ends (For_Uplink);
   package Down is new Variable_Ends (For_Downlink);
   package Framed is new Variable_Ends (For_Framed_Downlink);

   --  Expects exactly these errors in the log, the last one with this detail,
   --  the others with 0. Then the log is cleared.
   type Error_List is array (Positive range <>) of Error_Kind;
   None : constant Error_List := (1 .. 0 => Error_Kind'First);

   procedure Expect_Errors
     (What     : String;
      Log      : in out URV.Shared_Errors.Shared_Log;
      Expected : Error_List;
      Detail   : Word := 0);

   --  A buffer with mark m: word n is m + n, and its error/status word is 0.
   function Uplink_Of (Mark : Word) return Uplink_Buffer;
   function Downlink_Of (Mark : Word) return Downlink_Buffer;
   function Framed_Of (Mark : Word) return Framed_Downlink is
     (Words => Downlink_Of (Mark), Frame => Unknown_Frame);
   function Image_Of (Mark : Word; Error : Word) return AD_Image;

   procedure Expect_Buffer
     (What : String; Actual, Expected : Uplink_Buffer);
   procedure Expect_Buffer
     (What : String; Actual, Expected : Downlink_Buffer);

end Task_Rig;
