--  SPDX-License-Identifier: Apache-2.0

with Ada.Task_Identification; use Ada.Task_Identification;
with Ada.Task_Termination;    use Ada.Task_Termination;

with Host.Memory_Hardware;

package body Partitions.Exceptions is

   Longest : constant := 400;

   protected Latest is
      procedure Add (Text : String);
      function Number return Count;
      function First return String;
   private
      Total  : Count := 0;
      Text   : String (1 .. Longest) := (others => ' ');
      Length : Natural range 0 .. Longest := 0;
   end Latest;

   protected body Latest is

      procedure Add (Text : String) is
      begin
         if Total = 0 then
            Length := Natural'Min (Text'Length, Longest);
            Latest.Text (1 .. Length) :=
              Text (Text'First .. Text'First + Length - 1);
         end if;
         Total := Incremented (Total);
      end Add;

      function Number return Count is (Total);

      function First return String is (Text (1 .. Length));

   end Latest;

   procedure Report (Error : Exception_Occurrence) is
   begin
      if Exception_Identity (Error)
        /= Host.Memory_Hardware.Bus_Error'Identity
      then
         Latest.Add
           (Exception_Name (Error) & ": " & Exception_Message (Error));
      end if;
   end Report;

   function Number return Count is (Latest.Number);

   function First return String is (Latest.First);

   --  Tasks without a handler of their own end by an exception.
   protected Endings is
      procedure Note
        (Cause : Cause_Of_Termination;
         Which : Task_Id;
         Error : Exception_Occurrence);
   end Endings;

   protected body Endings is

      procedure Note
        (Cause : Cause_Of_Termination;
         Which : Task_Id;
         Error : Exception_Occurrence)
      is
         pragma Unreferenced (Which);
      begin
         if Cause = Unhandled_Exception then
            Report (Error);
         end if;
      end Note;

   end Endings;

begin
   Set_Dependents_Fallback_Handler (Endings.Note'Access);
end Partitions.Exceptions;
