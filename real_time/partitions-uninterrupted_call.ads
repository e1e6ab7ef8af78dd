--  Something that the converter's interrupt may not come into the midst of.

generic
   with procedure Call;
   with procedure Hold_Interrupts;
   with procedure Release_Interrupts;
procedure Partitions.Uninterrupted_Call;
