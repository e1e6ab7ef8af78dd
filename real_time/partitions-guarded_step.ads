--  A step of a task in the partition: what it runs, how long that takes, and
--  what catches an unexpected exception of the processor, which the target
--  has as an exception vector (KRN-6).
--
--  A transaction of a node that has stood still is not made, and has failed:
--  what it would pass on is old (SAF-4).

with Partitions.Measurements;

generic
   --  What the transaction takes, and when it ends after the tick at which
   --  its minor frame began; in tenths of microseconds.
   Cost     : in out Measurements.Distribution;
   Response : in out Measurements.Distribution;

   with function Has_Stood_Still return Boolean;
   with procedure Initialise;
   with procedure Run_Transaction;

   --  For who watches: the transaction is over.
   with procedure Observe;
procedure Partitions.Guarded_Step
  (First_Run : Boolean; Failed : out Boolean);
