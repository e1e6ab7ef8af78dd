--  SPDX-License-Identifier: Apache-2.0

--  A row of the flight recorder (FTI-9): the words of a major frame aboard,
--  as they are at its end. On the link and in files it has 72 words:
--
--  words 1, 2    number of the row since the cold start, high word first
--  words 3, 4    tick in which the row was made, modulo 2 ** 32
--  words 5 ..    the sensors with their error/status word, 28 words
--  words 33 ..   the commands heard with theirs, 14 words
--  words 47 ..   the words at the servos, 14 words
--  words 61 ..   the control laws: their report without the age, 6 words
--                (URV.Law_Status)
--  word 67       the test cards: the state in their report (URV.Card_Status)
--  word 68       number of errors in the log, at most 65535
--  word 69       kind of the last error, its place from 1; 0 for none
--  word 70       number of warm starts since the cold start, at most 65535
--  words 71, 72  sum of words 1 to 70, and sum of its partial sums

with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;
with URV.Buffers;  use URV.Buffers;

package URV.Recorder_Rows with Pure, SPARK_Mode is

   --  Rows are numbered from 0 after a cold start. 22 bits are 23 hours; the
   --  recorder stops at the last number.
   type Row_Number is range 0 .. 2 ** 22 - 1;

   type Law_Place is range 1 .. 6;
   type Law_Words is array (Law_Place) of Word;

   --  The words of the laws and of the test cards.
   type Recorded_Laws is record
      Laws  : Law_Words := (others => 0);
      Cards : Word      := 0;
   end record;

   type Recorded_Words is record
      Time     : Clock_Tick      := 0;
      Sensors  : Downlink_Buffer := (others => 0);
      Commands : Uplink_Buffer   := (others => 0);
      Servos   : PWM_Buffer      := (others => 0);
      Laws     : Law_Words       := (others => 0);
      Cards    : Word            := 0;
      Errors   : Word            := 0;
      Kind     : Word            := 0;
      Starts   : Word            := 0;
   end record;

   type Row is record
      Number   : Row_Number     := 0;
      Words    : Recorded_Words := (others => <>);
      Sum      : Word           := 0;
      Partials : Word           := 0;
   end record;

   --  The words of a row by their places

   type Row_Word is range 1 .. 72;

   subtype Content_Word is Row_Word range 1 .. 70;

   subtype Sensor_Word  is Content_Word range 5 .. 32;
   subtype Command_Word is Content_Word range 33 .. 46;
   subtype Servo_Word   is Content_Word range 47 .. 60;
   subtype Law_Word     is Content_Word range 61 .. 66;

   function Item_Of (Place : Sensor_Word) return Downlink_Item is
     (Downlink_Item'Val (Place - Sensor_Word'First))
   with Global => null;

   function Item_Of (Place : Command_Word) return Uplink_Item is
     (Uplink_Item'Val (Place - Command_Word'First))
   with Global => null;

   function Item_Of (Place : Servo_Word) return PWM_Item is
     (PWM_Item'Val (Place - Servo_Word'First))
   with Global => null;

   function Place_Of (Place : Law_Word) return Law_Place is
     (Law_Place (Place - Law_Word'First + 1))
   with Global => null;

   function Content_Of
     (Number : Row_Number; Words : Recorded_Words; Place : Content_Word)
      return Word
   is
     (case Place is
         when 1            => Word (Number / 2 ** 16),
         when 2            => Word (Number mod 2 ** 16),
         when 3            => Word (Words.Time / 2 ** 16 mod 2 ** 16),
         when 4            => Word (Words.Time mod 2 ** 16),
         when Sensor_Word  => Words.Sensors (Item_Of (Place)),
         when Command_Word => Words.Commands (Item_Of (Place)),
         when Servo_Word   => Words.Servos (Item_Of (Place)),
         when Law_Word     => Words.Laws (Place_Of (Place)),
         when 67           => Words.Cards,
         when 68           => Words.Errors,
         when 69           => Words.Kind,
         when 70           => Words.Starts)
   with Global => null;

   function Word_At (Item : Row; Place : Row_Word) return Word is
     (case Place is
         when Content_Word => Content_Of (Item.Number, Item.Words, Place),
         when 71           => Item.Sum,
         when 72           => Item.Partials)
   with Global => null;

   --  The sum of the contents up to a place, and that of its partial sums

   function Sum_Up_To
     (Number : Row_Number; Words : Recorded_Words; Place : Content_Word)
      return Word
   is
     ((if Place = 1 then 0 else Sum_Up_To (Number, Words, Place - 1))
      + Content_Of (Number, Words, Place))
   with
     Ghost,
     Global             => null,
     Subprogram_Variant => (Decreases => Place);

   function Partials_Up_To
     (Number : Row_Number; Words : Recorded_Words; Place : Content_Word)
      return Word
   is
     ((if Place = 1 then 0 else Partials_Up_To (Number, Words, Place - 1))
      + Sum_Up_To (Number, Words, Place))
   with
     Ghost,
     Global             => null,
     Subprogram_Variant => (Decreases => Place);

   --  The row of a frame, with its sums.
   function Row_Of (Number : Row_Number; Words : Recorded_Words) return Row
   with
     Global => null,
     Post   =>
       Row_Of'Result =
         (Number   => Number,
          Words    => Words,
          Sum      => Sum_Up_To (Number, Words, Content_Word'Last),
          Partials => Partials_Up_To (Number, Words, Content_Word'Last));

end URV.Recorder_Rows;
