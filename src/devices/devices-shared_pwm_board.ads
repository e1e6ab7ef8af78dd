--  A pulse width modulation board between the controller and the servos
--  (report, 4.8; PWM-1, D-13).

with Devices.PWM_Board; use Devices.PWM_Board;

generic
   --  What the board holds from power up until it is first written (SAF-1).
   Power_Up : Data_Area;
package Devices.Shared_PWM_Board
  with
    SPARK_Mode,
    Abstract_State =>
      (Board with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Board
is

   --  The controller's side: the whole area at once.
   procedure Write (Area : Data_Area)
   with Global => (In_Out => Board);

   --  The servos' side.
   procedure Read (Area : out Data_Area)
   with
     Global  => (Input => Board),
     Depends => (Area => Board);

end Devices.Shared_PWM_Board;
