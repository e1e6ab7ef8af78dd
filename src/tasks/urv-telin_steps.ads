--  SPDX-License-Identifier: Apache-2.0

--  The decision of the TELIN task (D-70): what it keeps and sends of what the
--  telemetry board received and the seal opened (report, 4.4; D-14, SAF-5,
--  SEC-1). The task receives, calls these functions, sends and reports;
--  Theorems.Safety calls the same functions. Each is an expression function:
--  its text is its contract.

with URVOS;            use URVOS;
with URV.Handshakes;   use URV.Handshakes;
with URV.Plain_Blocks; use URV.Plain_Blocks;

generic
   type Message is private;
   Neutral : Message;
   with function As_Old (Source : Message) return Message;
   with function Is_Old (Source : Message) return Boolean;
   with function Message_Of (Words : Block_Words) return Message;
package URV.TELIN_Steps with SPARK_Mode is

   --  The message that the task keeps from frame to frame, if any.
   type Kept_Message is record
      Buffer      : Message := Neutral;
      Has_Message : Boolean := False;
   end record;

   --  The message of a block that the seal opened. Without one it is the last
   --  message, marked as old.
   function Next
     (Kept : Kept_Message; Result : Outcome; Words : Block_Words)
      return Kept_Message
   is
     (if Result in Taken
      then (Buffer => Message_Of (Words), Has_Message => True)
      else (Kept with delta Buffer => As_Old (Kept.Buffer)))
   with Global => null;

   --  Nothing is sent before the first message.
   function Is_Sent (Kept : Kept_Message) return Boolean is
     (Kept.Has_Message)
   with Global => null;

   --  The kept message came in this frame, and its sender's data was new.
   function Is_New (Kept : Kept_Message) return Boolean is
     (Kept.Has_Message and then not Is_Old (Kept.Buffer))
   with Global => null;

   --  It is an error if no block came although there was an earlier one.
   function Is_Missed
     (Result : Outcome; Ever_Received : Boolean) return Boolean
   is
     (Result not in Taken and then Ever_Received)
   with Global => null;

   --  The detail of the error block_refused: the reason, counted from 1.
   function Reason (Result : Refused) return Word is
     (Word (Outcome'Pos (Result) - Outcome'Pos (Refused'First) + 1))
   with Global => null;

end URV.TELIN_Steps;
