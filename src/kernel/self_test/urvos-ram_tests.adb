--  SPDX-License-Identifier: Apache-2.0

package body URVOS.RAM_Tests with SPARK_Mode is

   Zeros : constant Word := 16#0000#;
   Ones  : constant Word := 16#FFFF#;

   --  Any two bits of a word differ in at least one of these.
   type Background_Number is range 1 .. 4;

   Backgrounds : constant array (Background_Number) of Word :=
     (16#5555#, 16#3333#, 16#0F0F#, 16#00FF#);

   --  The steps of the test. Each runs through the whole memory in the
   --  direction of its name, and ends at the first faulty word.

   procedure Fill (Data : Word)
   with
     Post =>
       (if Is_Model
        then (for all Place in 0 .. Last => Holds (Place, Data)));

   --  Up: write Data, write its complement, read, write Data, read.
   procedure Toggle_Up
     (Data  : Word;
      Sound : out Boolean;
      Where : out Word_Address)
   with
     Post =>
       Where <= Last
       and then (if Sound then Where = 0)
       and then (if Is_Model then Sound);

   --  Down: read Old, write Fresh.
   procedure Exchange_Down
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Word_Address)
   with
     Pre  =>
       (if Is_Model then (for all Place in 0 .. Last => Holds (Place, Old))),
     Post =>
       Where <= Last
       and then (if Sound then Where = 0)
       and then
         (if Is_Model
          then Sound
            and then (for all Place in 0 .. Last => Holds (Place, Fresh)));

   --  Up: read Old, write Fresh.
   procedure Exchange_Up
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Word_Address)
   with
     Pre  =>
       (if Is_Model then (for all Place in 0 .. Last => Holds (Place, Old))),
     Post =>
       Where <= Last
       and then (if Sound then Where = 0)
       and then
         (if Is_Model
          then Sound
            and then (for all Place in 0 .. Last => Holds (Place, Fresh)));

   --  Up: read Old, write Other, read Other, write Old.
   procedure There_And_Back_Up
     (Old, Other : Word;
      Sound      : out Boolean;
      Where      : out Word_Address)
   with
     Pre  =>
       (if Is_Model then (for all Place in 0 .. Last => Holds (Place, Old))),
     Post =>
       Where <= Last
       and then (if Sound then Where = 0)
       and then
         (if Is_Model
          then Sound
            and then (for all Place in 0 .. Last => Holds (Place, Old)));

   --  Up: read Data.
   procedure Verify_Up
     (Data  : Word;
      Sound : out Boolean;
      Where : out Word_Address)
   with
     Pre  =>
       (if Is_Model then (for all Place in 0 .. Last => Holds (Place, Data))),
     Post =>
       Where <= Last
       and then (if Sound then Where = 0)
       and then
         (if Is_Model
          then Sound
            and then (for all Place in 0 .. Last => Holds (Place, Data)));

   procedure Fill (Data : Word) is
   begin
      for Here in 0 .. Last loop
         Write (Here, Data);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in 0 .. Here => Holds (Place, Data)));
      end loop;
   end Fill;

   procedure Toggle_Up
     (Data  : Word;
      Sound : out Boolean;
      Where : out Word_Address)
   is
      Found : Word;
   begin
      for Here in 0 .. Last loop
         Write (Here, Data);
         Write (Here, not Data);
         Read (Here, Found);
         if Found /= (not Data) then
            Sound := False;
            Where := Here;
            return;
         end if;
         Write (Here, Data);
         Read (Here, Found);
         if Found /= Data then
            Sound := False;
            Where := Here;
            return;
         end if;
      end loop;
      Sound := True;
      Where := 0;
   end Toggle_Up;

   procedure Exchange_Down
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Word_Address)
   is
      Found : Word;
   begin
      for Here in reverse 0 .. Last loop
         Read (Here, Found);
         if Found /= Old then
            Sound := False;
            Where := Here;
            return;
         end if;
         Write (Here, Fresh);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in 0 .. Last =>
                    Holds (Place, (if Place >= Here then Fresh else Old))));
      end loop;
      Sound := True;
      Where := 0;
   end Exchange_Down;

   procedure Exchange_Up
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Word_Address)
   is
      Found : Word;
   begin
      for Here in 0 .. Last loop
         Read (Here, Found);
         if Found /= Old then
            Sound := False;
            Where := Here;
            return;
         end if;
         Write (Here, Fresh);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in 0 .. Last =>
                    Holds (Place, (if Place <= Here then Fresh else Old))));
      end loop;
      Sound := True;
      Where := 0;
   end Exchange_Up;

   procedure There_And_Back_Up
     (Old, Other : Word;
      Sound      : out Boolean;
      Where      : out Word_Address)
   is
      Found : Word;
   begin
      for Here in 0 .. Last loop
         Read (Here, Found);
         if Found /= Old then
            Sound := False;
            Where := Here;
            return;
         end if;
         Write (Here, Other);
         Read (Here, Found);
         if Found /= Other then
            Sound := False;
            Where := Here;
            return;
         end if;
         Write (Here, Old);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in 0 .. Last =>
                    Holds (Place, Old)));
      end loop;
      Sound := True;
      Where := 0;
   end There_And_Back_Up;

   procedure Verify_Up
     (Data  : Word;
      Sound : out Boolean;
      Where : out Word_Address)
   is
      Found : Word;
   begin
      for Here in 0 .. Last loop
         Read (Here, Found);
         if Found /= Data then
            Sound := False;
            Where := Here;
            return;
         end if;
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in 0 .. Last =>
                    Holds (Place, Data)));
      end loop;
      Sound := True;
      Where := 0;
   end Verify_Up;

   procedure Run (Sound : out Boolean; Where : out Word_Address) is
   begin
      for Number in Background_Number loop
         Toggle_Up (Backgrounds (Number), Sound, Where);
         if not Sound then
            return;
         end if;
      end loop;

      Fill (Zeros);
      Exchange_Down (Zeros, Ones, Sound, Where);
      if Sound then
         There_And_Back_Up (Ones, Zeros, Sound, Where);
      end if;
      if Sound then
         Exchange_Up (Ones, Zeros, Sound, Where);
      end if;
      if Sound then
         There_And_Back_Up (Zeros, Ones, Sound, Where);
      end if;
      if Sound then
         Verify_Up (Zeros, Sound, Where);
      end if;
   end Run;

end URVOS.RAM_Tests;
