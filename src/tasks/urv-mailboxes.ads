--  SPDX-License-Identifier: Apache-2.0

--  The variables between the tasks, one package for each type of message
--  (report, section 2.5; MBX-1). Each is a mailbox that two tasks share.

with URV.Buffers; use URV.Buffers;
with URVOS.Shared_Mailboxes;

package URV.Mailboxes with SPARK_Mode is

   --  The ground's converter reads the sticks, the aircraft's the sensors

   package For_Stick_Words is
     new URVOS.Shared_Mailboxes (Channel_Words, Neutral_Stick_Words);

   package For_Stick_Images is
     new URVOS.Shared_Mailboxes (AD_Image, Neutral_Stick_Image);

   package For_Sensor_Words is
     new URVOS.Shared_Mailboxes (Channel_Words, Neutral_Sensor_Words);

   package For_Sensor_Images is
     new URVOS.Shared_Mailboxes (AD_Image, Neutral_Sensor_Image);

   package For_Uplink is
     new URVOS.Shared_Mailboxes (Uplink_Buffer, Neutral_Uplink);

   package For_Downlink is
     new URVOS.Shared_Mailboxes (Downlink_Buffer, Neutral_Downlink);

   package For_Framed_Downlink is
     new URVOS.Shared_Mailboxes (Framed_Downlink, Neutral_Framed_Downlink);

end URV.Mailboxes;
