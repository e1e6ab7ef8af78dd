--  An analog-to-digital board between the controller and its hardware
--  (report, 4.1, 4.2; AD-1, ADI-1).

with URVOS;            use URVOS;
with Devices.AD_Board; use Devices.AD_Board;

generic
package Devices.Shared_AD_Board
  with
    SPARK_Mode,
    Abstract_State =>
      (Board with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Board
is

   --  The controller's side.

   procedure Initialise
   with Global => (In_Out => Board);

   procedure Start (Channel : Channel_Number)
   with
     Global  => (In_Out => Board),
     Depends => (Board => (Board, Channel));

   procedure Read (Data : out Word)
   with
     Global  => (Input => Board),
     Depends => (Data => Board);

   --  The hardware's side.

   --  Wanted tells whether a conversion was started since this was last
   --  asked, and of which channel.
   procedure Take_Start (Wanted : out Boolean; Channel : out Channel_Number)
   with
     Global  => (In_Out => Board),
     Depends => ((Board, Wanted, Channel) => Board);

   --  The conversion is done; Interrupt tells whether the controller is
   --  interrupted. It is not, and the value is nobody's, when the controller
   --  has abandoned that conversion, of which the hardware may not know yet.
   procedure Finish (Value : Word; Interrupt : out Boolean)
   with Global => (In_Out => Board);

end Devices.Shared_AD_Board;
