--  SPDX-License-Identifier: Apache-2.0

--  From TELOUT on the ground to TELIN in the aircraft, sealed or not (SEC-1,
--  SAF-2, TOU-1, TIN-1): a message that TELIN takes is one that TELOUT sent.
--  Theorems.Safety has the line without a seal; this theorem adds the seal.
--  It makes the same calls as the tasks' bodies. The line neither forges nor
--  delays here: a block is the one just sealed. Theorems.Seals has the age.

with Telemetry;         use Telemetry;
with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Handshakes;    use URV.Handshakes;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Type_Codes;    use URV.Type_Codes;
with URV.Uplink_Input;  use URV.Uplink_Input;

package Theorems.Sealed_Commands with SPARK_Mode, Ghost is

   --  A word on the line: in format 2 it is limited to 12 bits (D-11).
   function Carried (Value : Word; Format : Format_Number) return Word is
     (if Format = 1 then Value else Clipped (Value))
   with Global => null;

   --  For any states of the two seals: a block that is taken has the commands,
   --  the flags and the servos' words of the message. After any other block
   --  the last commands remain, marked as old.
   procedure A_Taken_Message_Was_Sent
     (Message : Uplink_Buffer;
      Sending : in out Seal;
      Opening : in out Seal;
      Kept    : in out Kept_Message;
      Result  : out Outcome)
   with
     Global => null,
     Pre    =>
       Sending.Role = Ground
       and then Opening.Role = Aircraft
       and then Sending.Format = Opening.Format,
     Post   =>
       (if Result in Taken
        then
          (for all Name in Command_Item =>
             Kept.Buffer (Name) = Carried (Message (Name), Opening'Old.Format))
          and then Is_Old (Kept.Buffer) = Is_Old (Message)
          and then Is_Other_Kind (Kept.Buffer) = Is_Other_Kind (Message)
          and then
            (for all Name in PWM_Item =>
               Transform (Kept.Buffer) (Name) = Transform (Message) (Name))
        else
          Is_Old (Kept.Buffer)
          and then
            (for all Name in Command_Item =>
               Kept.Buffer (Name) = Kept'Old.Buffer (Name)));

end Theorems.Sealed_Commands;
