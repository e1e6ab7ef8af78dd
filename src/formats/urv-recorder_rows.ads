--  SPDX-License-Identifier: Apache-2.0

--  A row of the flight recorder (FTI-9): the words of a major frame aboard,
--  as they are at its end. On the link and in files it has 72 words:
--
--  words 1, 2    number of the row since the cold start, high word first
--  words 3, 4    tick in which the row was made, modulo 2 ** 32
--  words 5 ..    the sensors with their error/status word
--  then          the commands heard with theirs
--                the words at the servos
--                the control laws: their report without the age, 6 words
--                (URV.Law_Status)
--                the test cards: the state in their report (URV.Card_Status)
--                number of errors in the log, at most 65535
--                low byte: kind of the last error, its place from 1; 0 for
--                none; high byte: number of warm starts since the cold start,
--                at most 255
--  up to 70      0
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

   subtype Byte_Word is Word range 0 .. 255;

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
      Kind     : Byte_Word       := 0;
      Starts   : Byte_Word       := 0;
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

   --  The places follow from the numbers of words.

   Sensor_Count  : constant := Downlink_Item'Pos (Downlink_Item'Last) + 1;
   Command_Count : constant := Uplink_Item'Pos (Uplink_Item'Last) + 1;
   Servo_Count   : constant := PWM_Item'Pos (PWM_Item'Last) + 1;
   Law_Count     : constant := 6;

   --  The places of the test cards, the number of errors, the last word.
   Card_Place  : constant :=
     5 + Sensor_Count + Command_Count + Servo_Count + Law_Count;
   Error_Place : constant := Card_Place + 1;
   Last_Place  : constant := Card_Place + 2;

   pragma Compile_Time_Error
     (Last_Place > 70,
      "a row of the recorder has no room for more words of a buffer");

   subtype Sensor_Word  is Content_Word range 5 .. 4 + Sensor_Count;
   subtype Command_Word is Content_Word
     range Sensor_Word'Last + 1 .. Sensor_Word'Last + Command_Count;
   subtype Servo_Word   is Content_Word
     range Command_Word'Last + 1 .. Command_Word'Last + Servo_Count;
   subtype Law_Word     is Content_Word
     range Servo_Word'Last + 1 .. Servo_Word'Last + Law_Count;
   subtype Other_Word   is Content_Word
     range Law_Word'Last + 1 .. Content_Word'Last;

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
         when Other_Word   =>
           (if Place = Card_Place then Words.Cards
            elsif Place = Error_Place then Words.Errors
            elsif Place = Last_Place then 2 ** 8 * Words.Starts + Words.Kind
            else 0))
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
