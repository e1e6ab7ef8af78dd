--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Error_Marks is

   Mark : constant Byte := 16#FF#;

   procedure Take
     (Reader       : in out Mark_Reader;
      Data         : Byte;
      Found        : out Boolean;
      Parity_Error : out Boolean) is
   begin
      Parity_Error := Reader.Now_At = At_Damaged;
      case Reader.Now_At is
         when At_Character =>
            Found := Data /= Mark;
            Reader.Now_At := (if Found then At_Character else After_Mark);
         when After_Mark =>
            --  Another FF: the character was an FF.
            Found := Data = Mark;
            Reader.Now_At := (if Found then At_Character else At_Damaged);
         when At_Damaged =>
            Found := True;
            Reader.Now_At := At_Character;
      end case;
   end Take;

   procedure Forget (Reader : in out Mark_Reader) is
   begin
      Reader.Now_At := At_Character;
   end Forget;

end Partitions.Error_Marks;
