--  SPDX-License-Identifier: Apache-2.0

package body URVOS.RAM_Tests with SPARK_Mode is

   Zeros : constant Word := 0;
   Ones  : constant Word := not 0;

   --  The backgrounds, in each word. Any two bits of a word differ in at least
   --  one of them.
   Singles : constant Wide := Wide'Last / 3;     --  5555, hexadecimal
   Pairs   : constant Wide := Wide'Last / 5;     --  3333
   Fours   : constant Wide := Wide'Last / 17;    --  0F0F
   Eights  : constant Wide := Wide'Last / 257;   --  00FF

   --  The steps of the test. Each runs through the whole memory in the
   --  direction of its name, and ends at the first faulty word. The data are
   --  parameters of calls, so that they are in registers (build.sh).

   --  Up: write each background, write its complement, read, write the
   --  background, read. Then write zeros.
   procedure Backgrounds_Up
     (First_One, Second, Third, Fourth : Wide;
      Sound                            : out Boolean;
      Where                            : out Address)
   with
     No_Inline,
     Post =>
       Where in First .. Last
       and then (if Sound then Where = First)
       and then
         (if Is_Model
          then Sound
            and then
              (for all Place in First .. Last => Holds (Place, Zeros)));

   --  Down: read Old, write Fresh.
   procedure Exchange_Down
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Address)
   with
     No_Inline,
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
     No_Inline,
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
     No_Inline,
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

   --  Up: read zeros.
   procedure Verify_Up (Sound : out Boolean; Where : out Address)
   with
     No_Inline,
     Pre  =>
       (if Is_Model
        then (for all Place in First .. Last => Holds (Place, Zeros))),
     Post =>
       Where in First .. Last
       and then (if Sound then Where = First)
       and then
         (if Is_Model
          then Sound
            and then
              (for all Place in First .. Last => Holds (Place, Zeros)));

   function Is_Zero_Below (Here : Address) return Boolean is
     (for all Place in First .. Last =>
        (if Place < Here then Holds (Place, Zeros)))
   with Ghost;

   --  Write Data, write its complement, read, write Data, read.
   procedure Toggle
     (Here  : Address;
      Data  : Wide;
      Sound : out Boolean)
   with
     Inline,
     Pre  =>
       Here in First .. Last
       and then (Here - First) mod Wide_Step = 0
       and then (if Is_Model then Is_Zero_Below (Here)),
     Post =>
       (if Is_Model then Sound and then Is_Zero_Below (Here));

   procedure Toggle
     (Here  : Address;
      Data  : Wide;
      Sound : out Boolean)
   is
      Found : Wide;
   begin
      Write_Wide (Here, Data);
      Write_Wide (Here, not Data);
      Read_Wide (Here, Found);
      Sound := Found = (not Data);
      if Sound then
         Write_Wide (Here, Data);
         Read_Wide (Here, Found);
         Sound := Found = Data;
      end if;
   end Toggle;

   procedure Backgrounds_Up
     (First_One, Second, Third, Fourth : Wide;
      Sound                            : out Boolean;
      Where                            : out Address)
   is
      Here         : Address := First;
      Last_But_One : constant Address := Last - Wide_Step;
   begin
      loop
         Toggle (Here, First_One, Sound);
         if Sound then
            Toggle (Here, Second, Sound);
         end if;
         if Sound then
            Toggle (Here, Third, Sound);
         end if;
         if Sound then
            Toggle (Here, Fourth, Sound);
         end if;
         if not Sound then
            Where := Here;
            return;
         end if;
         Write_Wide (Here, 0);
         pragma Loop_Invariant (Here in First .. Last);
         pragma Loop_Invariant ((Here - First) mod Wide_Step = 0);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in First .. Here => Holds (Place, Zeros)));
         pragma Loop_Variant (Increases => Here);
         exit when Here > Last_But_One;
         Here := Here + Wide_Step;
      end loop;
      Sound := True;
      Where := First;
   end Backgrounds_Up;

   procedure Exchange_Down
     (Old, Fresh : Word;
      Sound      : out Boolean;
      Where      : out Address)
   is
      Found  : Word;
      Here   : Address := Last;
      Second : constant Address := First + Step;
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
         exit when Here < Second;
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
      Found        : Word;
      Here         : Address := First;
      Last_But_One : constant Address := Last - Step;
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
         exit when Here > Last_But_One;
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
      Found        : Word;
      Here         : Address := First;
      Last_But_One : constant Address := Last - Step;
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
         exit when Here > Last_But_One;
         Here := Here + Step;
      end loop;
      Sound := True;
      Where := First;
   end There_And_Back_Up;

   procedure Verify_Up (Sound : out Boolean; Where : out Address) is
      Found        : Wide;
      Here         : Address := First;
      Last_But_One : constant Address := Last - Wide_Step;
   begin
      loop
         Read_Wide (Here, Found);
         if Found /= 0 then
            Sound := False;
            Where := Here;
            return;
         end if;
         pragma Loop_Invariant (Here in First .. Last);
         pragma Loop_Invariant ((Here - First) mod Wide_Step = 0);
         pragma Loop_Invariant
           (if Is_Model
            then (for all Place in First .. Last =>
                    Holds (Place, Zeros)));
         pragma Loop_Variant (Increases => Here);
         exit when Here > Last_But_One;
         Here := Here + Wide_Step;
      end loop;
      Sound := True;
      Where := First;
   end Verify_Up;

   procedure Run (Sound : out Boolean; Where : out Address) is
   begin
      Backgrounds_Up (Singles, Pairs, Fours, Eights, Sound, Where);
      if Sound then
         Exchange_Down (Zeros, Ones, Sound, Where);
      end if;
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
         Verify_Up (Sound, Where);
      end if;
   end Run;

end URVOS.RAM_Tests;
