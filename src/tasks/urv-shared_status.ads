--  What a node adds to the error/status word of what it sends (TST-4): the
--  check of the program memory in flight has found a difference.

with URVOS; use URVOS;

generic
package URV.Shared_Status
  with
    SPARK_Mode,
    Abstract_State =>
      (Status with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Status
is

   --  Sets the node's bits: see URV.Buffers.
   procedure Write (Bits : Word)
   with
     Global  => (In_Out => Status),
     Depends => (Status => (Status, Bits));

   procedure Read (Bits : out Word)
   with
     Global  => (Input => Status),
     Depends => (Bits => Status);

end URV.Shared_Status;
