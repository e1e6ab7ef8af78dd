--  SPDX-License-Identifier: Apache-2.0

--  The decisions of the flight recorder (FTI-9, FTI-10, D-70): when it makes
--  rows, and what goes down of them. URV.Flight_Recorder and
--  URV.Recorder_Senders call them. Each is an expression function: its text
--  is its contract.

with URVOS;               use URVOS;
with URVOS.Frames;        use URVOS.Frames;
with URV.Buffers;         use URV.Buffers;
with URV.Law_Gains;       use URV.Law_Gains;
with URV.Recorder_Blocks; use URV.Recorder_Blocks;
with URV.Recorder_Rings;  use URV.Recorder_Rings;
with URV.Recorder_Rows;   use URV.Recorder_Rows;

package URV.Recorder_Steps with Pure, SPARK_Mode is

   --  By its words of this frame the aircraft is slow and low, or it is not.
   --  Neither is known from old words. No memory of the laws is needed, which
   --  may be off.

   function Is_On_Ground (Sensors : Downlink_Buffer) return Boolean is
     (not Is_Old (Sensors)
      and then Sensors (Airspeed) < Flying_Speed
      and then Sensors (Altitude) < Flying_Height)
   with Global => null;

   function Is_Flying (Sensors : Downlink_Buffer) return Boolean is
     (not Is_Old (Sensors)
      and then
        (Sensors (Airspeed) >= Flying_Speed
         or else Sensors (Altitude) >= Flying_Height))
   with Global => null;

   --  The recorder stops a second after a landing, so that the flight remains,
   --  and while its rows are fetched. It goes on when the aircraft flies.

   Frames_After_Landing : constant :=
     1_000_000 / (Ticks_Per_Major_Frame * Microseconds_Per_Tick);

   type Ground_Frames is range 0 .. Frames_After_Landing;

   --  Has_Flown: since the cold start. On_Ground: frames in a row. Is_Asked:
   --  rows were fetched since the last flight.
   type Watch is record
      Has_Flown : Boolean       := False;
      On_Ground : Ground_Frames := 0;
      Is_Asked  : Boolean       := False;
   end record
   with Alignment => 2;

   function Is_Recording (This : Watch) return Boolean is
     (not This.Is_Asked
      and then
        (not This.Has_Flown or else This.On_Ground < Ground_Frames'Last))
   with Global => null;

   --  The watch after a frame.
   function After (This : Watch; Sensors : Downlink_Buffer) return Watch is
     (if Is_Flying (Sensors) then (Has_Flown => True, others => <>)
      elsif Is_On_Ground (Sensors)
        and then This.On_Ground < Ground_Frames'Last
      then (This with delta On_Ground => This.On_Ground + 1)
      else This)
   with Global => null;

   --  The aircraft sends the report, then the quarters of each row. A frame
   --  with sensors follows each row.

   type Turn is (Idle, Report, Quarter, Sensors_Turn);

   type Line is record
      Now   : Turn       := Idle;
      Reply : Answer     := Accepted;
      Next  : Row_Number := 0;
      Left  : Field      := 0;
      Which : Part       := 0;
   end record;

   --  The first row of an answer: the requested one, or the oldest.
   function Begin_Of (Item : Request; Kept : Ring) return Row_Number is
     (Row_Number'Max (Item.First, First (Kept)))
   with Global => null;

   function Reply_To
     (Item : Request; Kept : Ring; On_Ground : Boolean) return Answer
   is
     (if not On_Ground then Flies
      elsif not Is_Held (Kept, Begin_Of (Item, Kept)) then Not_Held
      else Accepted)
   with Global => null;

   --  A new request replaces the one before.
   function Asked
     (Item : Request; Kept : Ring; On_Ground : Boolean) return Line
   is
     ((Now   => Report,
       Reply => Reply_To (Item, Kept, On_Ground),
       Next  => Begin_Of (Item, Kept),
       Left  =>
         (if Reply_To (Item, Kept, On_Ground) = Accepted then Item.Rows
          else 0),
       Which => 0))
   with Global => null;

   --  This frame has a block in place of the sensors.
   function Has_Block (This : Line; Kept : Ring; On_Ground : Boolean)
                       return Boolean
   is
     (This.Now = Report
      or else
        (This.Now = Quarter
         and then On_Ground
         and then Is_Held (Kept, This.Next)))
   with Global => null;

   --  The line after a frame. It ends when all rows are sent, when the row is
   --  not held, and when the aircraft flies.
   function After (This : Line; Kept : Ring; On_Ground : Boolean) return Line
   is
     (if This.Left = 0 or else not On_Ground
        or else not Is_Held (Kept, This.Next)
      then (others => <>)
      else
        (case This.Now is
            when Idle         => This,
            when Report       => (This with delta Now => Quarter),
            when Quarter      =>
              (if This.Which < Part'Last
               then (This with delta Which => This.Which + 1)
               else
                 (This with delta
                    Now   => Sensors_Turn,
                    Which => 0,
                    Next  => This.Next + 1,
                    Left  => This.Left - 1)),
            when Sensors_Turn => (This with delta Now => Quarter)))
   with Global => null;

end URV.Recorder_Steps;
