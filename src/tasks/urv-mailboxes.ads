--  The mailboxes between the tasks, one for each kind of message (report,
--  section 2.5; MBX-1). A node's variables are mailboxes of these kinds,
--  each shared by two tasks.

with URV.Buffers; use URV.Buffers;
with URVOS.Mailboxes;

package URV.Mailboxes with SPARK_Mode is

   package For_Channels is new URVOS.Mailboxes (Channel_Words, Neutral_Words);

   package For_Images is new URVOS.Mailboxes (AD_Image, Neutral_Image);

   package For_Uplink is new URVOS.Mailboxes (Uplink_Buffer, Neutral_Uplink);

   package For_Downlink is
     new URVOS.Mailboxes (Downlink_Buffer, Neutral_Downlink);

end URV.Mailboxes;
