--  SPDX-License-Identifier: Apache-2.0

--  The state of the converter as the reference manual describes it, for
--  contracts (BRD-9, D-92). Just before an access of the program the
--  conversion under way may end: Follows permits that.

package STM32_ADC.Models with Pure, SPARK_Mode is

   type Converter_Model is record
      Settings   : Control_1;
      More       : Control_2;
      Sampling   : Sampling_Time;

      --  The channel of the next conversion.
      Channel    : Channel_Number;

      --  The conversions started since power up, the channel of the last one,
      --  and whether it is under way.
      Started    : Event_Number;
      Sampled    : Channel_Number;
      Converting : Boolean;

      --  The data register has a value that was not read, and the number of
      --  its conversion.
      Converted  : Boolean;
      Present    : Event_Number;

      --  Values lost since power up, and the flag. A loss sets it.
      Losses     : Event_Number;
      Overrun    : Boolean;
   end record;

   function Same_Settings (One, Other : Converter_Model) return Boolean is
     (One.Settings = Other.Settings
      and then One.More = Other.More
      and then One.Sampling = Other.Sampling
      and then One.Channel = Other.Channel
      and then One.Started = Other.Started
      and then One.Sampled = Other.Sampled);

   --  The conversion has ended. If the last value was not read, one of both is
   --  lost; which one, the manual does not say.
   function Has_Ended (After, Before : Converter_Model) return Boolean is
     (not After.Converting
      and then After.Converted
      and then
        (if Before.Converted
         then After.Overrun
           and then After.Losses = Before.Losses + 1
           and then After.Present in Before.Present | Before.Started
         else After.Overrun = Before.Overrun
           and then After.Losses = Before.Losses
           and then After.Present = Before.Started));

   function Is_Unchanged (After, Before : Converter_Model) return Boolean is
     (After.Converting = Before.Converting
      and then After.Converted = Before.Converted
      and then After.Present = Before.Present
      and then After.Losses = Before.Losses
      and then After.Overrun = Before.Overrun);

   function Follows (After, Before : Converter_Model) return Boolean is
     (Same_Settings (After, Before)
      and then
        (Is_Unchanged (After, Before)
         or else
           (Before.Converting and then Has_Ended (After, Before))));

   function Shows (Item : Status; This : Converter_Model) return Boolean is
     (Item.Converted = This.Converted and then Item.Overrun = This.Overrun);

   --  A read of the data register takes the value. The conversion may have
   --  ended just before.
   function Is_Read (After, Before : Converter_Model) return Boolean is
     (not After.Converted
      and then
        Follows
          ((After with delta
              Converted => Before.Converted
                or else (Before.Converting and then not After.Converting)),
           Before));

   --  A switch to off stops the conversion. Before the next start the flags
   --  mean nothing.
   function Is_Stopped (After, Before : Converter_Model) return Boolean is
     (not After.Converting
      and then After.Settings = Before.Settings
      and then After.Sampling = Before.Sampling
      and then After.Channel = Before.Channel
      and then After.Started = Before.Started
      and then After.Sampled = Before.Sampled);

   function With_Start (This : Converter_Model) return Converter_Model is
     ((This with delta
         Started    => This.Started + 1,
         Sampled    => This.Channel,
         Converting => True));

end STM32_ADC.Models;
