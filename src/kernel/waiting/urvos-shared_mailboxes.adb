package body URVOS.Shared_Mailboxes
  with
    SPARK_Mode,
    Refined_State => (Box => Guarded_Box)
is

   protected Guarded_Box is

      procedure Send (Item : Message; Success : out Boolean);

      procedure Look (Item : out Message; Fresh : out Boolean);

      procedure Receive (Item : out Message; Fresh : out Boolean);

      procedure Reset;

      procedure Restart;

      function Snapshot return Boxes.Mailbox;

   private
      Contents : Boxes.Mailbox;
   end Guarded_Box;

   protected body Guarded_Box is

      procedure Send (Item : Message; Success : out Boolean) is
      begin
         Boxes.Send (Contents, Item, Success);
      end Send;

      procedure Look (Item : out Message; Fresh : out Boolean) is
      begin
         Boxes.Look (Contents, Item, Fresh);
      end Look;

      procedure Receive (Item : out Message; Fresh : out Boolean) is
      begin
         Boxes.Receive (Contents, Item, Fresh);
      end Receive;

      procedure Reset is
      begin
         Contents := Boxes.Empty_Mailbox;
      end Reset;

      procedure Restart is
      begin
         Contents := Boxes.Restarted (Contents);
      end Restart;

      function Snapshot return Boxes.Mailbox is (Contents);

   end Guarded_Box;

   procedure Send (Item : Message; Success : out Boolean) is
   begin
      Guarded_Box.Send (Item, Success);
   end Send;

   procedure Look (Item : out Message; Fresh : out Boolean) is
   begin
      Guarded_Box.Look (Item, Fresh);
   end Look;

   procedure Receive (Item : out Message; Fresh : out Boolean) is
   begin
      Guarded_Box.Receive (Item, Fresh);
   end Receive;

   procedure Reset is
   begin
      Guarded_Box.Reset;
   end Reset;

   procedure Restart is
   begin
      Guarded_Box.Restart;
   end Restart;

   procedure Inspect (Snapshot : out Boxes.Mailbox) is
   begin
      Snapshot := Guarded_Box.Snapshot;
   end Inspect;

end URVOS.Shared_Mailboxes;
