--  SPDX-License-Identifier: Apache-2.0

package body URVOS.RAM_Tests with SPARK_Mode is

   Zeros : constant Word := 0;
   Ones  : constant Word := not 0;

   --  Any two bits of a word differ in at least one of these.
   type Background_Number is range 1 .. 4;

   Backgrounds : constant array (Background_Number) of Wide :=
     (Wide'Last / 3,       --  5555, hexadecimal, in each word
      Wide'Last / 5,       --  3333
      Wide'Last / 17,      --  0F0F
      Wide'Last / 257);    --  00FF

   --  The steps of the test. Each runs through the whole memory in the
   --  direction of its name, and ends at the first faulty word.

   procedure Fill (Data : Word)
   with
     Post =>
       (if Is_Model
        then (for all Place in First .. Last => Holds (Place, Data)));

   --  Up: write Data, write its complement, read, write Data, read.
   procedure Toggle_Up
     (Data  : Wide;
      Sound : out Boolean;
      Where : out Address)
   with
     Post =>
       Where in First .. Last
       and then (if Sound then Where = First)
       and then (if Is_Model then Sound);

   --  Down: read Old, write Fresh.
   procedure Exchange_Down
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Address)
   with
     Pre  =>
       (if Is_Model
        then (for all Place in First .. Last => Holds (Place, Old))),
     Post =>
       Where in First .. Last
       and then (if Sound then Where = First)
       and then
         (if Is_Model
          then Sound
            and then (for all Place in First .. Last => Holds (Place, Fresh)));

   --  Up: read Old, write Fresh.
   procedure Exchange_Up
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Address)
   with
     Pre  =>
       (if Is_Model
        then (for all Place in First .. Last => Holds (Place, Old))),
     Post =>
       Where in First .. Last
       and then (if Sound then Where = First)
       and then
         (if Is_Model
          then Sound
            and then (for all Place in First .. Last => Holds (Place, Fresh)));

   --  Up: read Old, write Other, read Other, write Old.
   procedure There_And_Back_Up
     (Old, Other : Word;
      Sound      : out Boolean;
      Where      : out Address)
   with
     Pre  =>
       (if Is_Model
        then (for all Place in First .. Last => Holds (Place, Old))),
     Post =>
       Where in First .. Last
       and then (if Sound then Where = First)
       and then
         (if Is_Model
          then Sound
            and then (for all Place in First .. Last => Holds (Place, Old)));

   --  Up: read Data.
   procedure Verify_Up
     (Data  : Word;
      Sound : out Boolean;
      Where : out Address)
   with
     Pre  =>
       (if Is_Model
        then (for all Place in First .. Last => Holds (Place, Data))),
     Post =>
       Where in First .. Last
       and then (if Sound then Where = First)
       and then
         (if Is_Model
          then Sound
            and then (for all Place in First .. Last => Holds (Place, Data)));

   procedure Fill (Data : Word) is
      Here : Address := First;
   begin
      loop
         Write (Here, Data);
         pragma Loop_Invariant (Here in First .. Last);
         pragma Loop_Invariant ((Here - First) mod Step = 0);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in First .. Here =>
                    Holds (Place, Data)));
         pragma Loop_Variant (Increases => Here);
         exit when Here > Last - Step;
         Here := Here + Step;
      end loop;
   end Fill;

   procedure Toggle_Up
     (Data  : Wide;
      Sound : out Boolean;
      Where : out Address)
   is
      Found : Wide;
      Here  : Address := First;
   begin
      loop
         Write_Wide (Here, Data);
         Write_Wide (Here, not Data);
         Read_Wide (Here, Found);
         if Found /= (not Data) then
            Sound := False;
            Where := Here;
            return;
         end if;
         Write_Wide (Here, Data);
         Read_Wide (Here, Found);
         if Found /= Data then
            Sound := False;
            Where := Here;
            return;
         end if;
         pragma Loop_Invariant (Here in First .. Last);
         pragma Loop_Invariant ((Here - First) mod Wide_Step = 0);
         pragma Loop_Variant (Increases => Here);
         exit when Here > Last - Wide_Step;
         Here := Here + Wide_Step;
      end loop;
      Sound := True;
      Where := First;
   end Toggle_Up;

   procedure Exchange_Down
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Address)
   is
      Found : Word;
      Here  : Address := Last;
   begin
      loop
         Read (Here, Found);
         if Found /= Old then
            Sound := False;
            Where := Here;
            return;
         end if;
         Write (Here, Fresh);
         pragma Loop_Invariant (Here in First .. Last);
         pragma Loop_Invariant ((Last - Here) mod Step = 0);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in First .. Last =>
                    Holds (Place, (if Place >= Here then Fresh else Old))));
         pragma Loop_Variant (Decreases => Here);
         exit when Here < First + Step;
         Here := Here - Step;
      end loop;
      Sound := True;
      Where := First;
   end Exchange_Down;

   procedure Exchange_Up
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Address)
   is
      Found : Word;
      Here  : Address := First;
   begin
      loop
         Read (Here, Found);
         if Found /= Old then
            Sound := False;
            Where := Here;
            return;
         end if;
         Write (Here, Fresh);
         pragma Loop_Invariant (Here in First .. Last);
         pragma Loop_Invariant ((Here - First) mod Step = 0);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in First .. Last =>
                    Holds (Place, (if Place <= Here then Fresh else Old))));
         pragma Loop_Variant (Increases => Here);
         exit when Here > Last - Step;
         Here := Here + Step;
      end loop;
      Sound := True;
      Where := First;
   end Exchange_Up;

   procedure There_And_Back_Up
     (Old, Other : Word;
      Sound      : out Boolean;
      Where      : out Address)
   is
      Found : Word;
      Here  : Address := First;
   begin
      loop
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
         pragma Loop_Invariant (Here in First .. Last);
         pragma Loop_Invariant ((Here - First) mod Step = 0);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in First .. Last =>
                    Holds (Place, Old)));
         pragma Loop_Variant (Increases => Here);
         exit when Here > Last - Step;
         Here := Here + Step;
      end loop;
      Sound := True;
      Where := First;
   end There_And_Back_Up;

   procedure Verify_Up
     (Data  : Word;
      Sound : out Boolean;
      Where : out Address)
   is
      Found : Word;
      Here  : Address := First;
   begin
      loop
         Read (Here, Found);
         if Found /= Data then
            Sound := False;
            Where := Here;
            return;
         end if;
         pragma Loop_Invariant (Here in First .. Last);
         pragma Loop_Invariant ((Here - First) mod Step = 0);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in First .. Last =>
                    Holds (Place, Data)));
         pragma Loop_Variant (Increases => Here);
         exit when Here > Last - Step;
         Here := Here + Step;
      end loop;
      Sound := True;
      Where := First;
   end Verify_Up;

   procedure Run (Sound : out Boolean; Where : out Address) is
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
