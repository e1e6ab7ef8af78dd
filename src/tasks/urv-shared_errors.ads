--  The error counts of a node, which all its tasks share.

with URV.Errors; use URV.Errors;

generic
package URV.Shared_Errors
  with
    SPARK_Mode,
    Abstract_State =>
      (Counts with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Counts
is

   procedure Report (Kind : Error_Kind)
   with
     Global  => (In_Out => Counts),
     Depends => (Counts => (Counts, Kind));

   procedure Clear
   with Global => (In_Out => Counts);

   procedure Inspect (Snapshot : out Error_Counts)
   with
     Global  => (Input => Counts),
     Depends => (Snapshot => Counts);

end URV.Shared_Errors;
