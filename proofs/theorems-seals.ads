--  SPDX-License-Identifier: Apache-2.0

--  The sealed link: what is sealed comes through, and nothing is taken twice
--  or late (SEC-1, SEC-3, SEC-4).
--
--  That nobody without the key finds a tag is not proved, here or anywhere:
--  it is what SipHash is believed to do.

with Telemetry;       use Telemetry;
with URVOS;           use URVOS;
with URV.Seal_Blocks; use URV.Seal_Blocks;
with URV.Seals;       use URV.Seals;
with URV.Sessions;    use URV.Sessions;
with URV.Sip_Hash;    use URV.Sip_Hash;

package Theorems.Seals with SPARK_Mode, Ghost is

   --  A word of a block as its receiver has it: clipped to 12 bits (D-11);
   --  of the last word up the flags, down all (D-15).
   function Carried
     (Data   : Block_Data;
      Sender : Station;
      Which  : Word_Place) return Word
   is
     (if Which < Words_Of (Sender) then Clipped (Word_At (Data, Which))
      elsif Sender = Ground then Word_At (Data, Which) mod 16
      else Word_At (Data, Which))
   with
     Global => null,
     Pre    => Which <= Words_Of (Sender);

   procedure Words_Come_Through
     (Data   : Block_Data;
      Sender : Station;
      Number : Counter;
      Inside : Session;
      Which  : Word_Place)
   with
     Global => null,
     Pre    => Which <= Words_Of (Sender),
     Post   =>
       Word_At
         (Unpacked (Sealed (Data, Sender, Number, Inside), Sender), Which) =
       Carried (Data, Sender, Which);

   --  A block opens for whoever has the session, as long as it is newer than
   --  all that was taken, up by 4096 at most.
   procedure What_Is_Sealed_Opens
     (Data   : Block_Data;
      Sender : Station;
      Number : Counter;
      Mine   : Session;
      Theirs : Session)
   with
     Global => null,
     Pre    =>
       Theirs.Is_Present
       and then Key_Of (Mine, Sender) = Key_Of (Theirs, Sender)
       and then Theirs.Newest < Last_Number
       and then Number > Theirs.Newest
       and then Number - Theirs.Newest <= Numbers_Told,
     Post   =>
       Number_Of
         (Sealed (Data, Sender, Number, Mine), Sender, Theirs.Newest) =
           Number
       and then Opens (Sealed (Data, Sender, Number, Mine), Sender, Theirs);

   --  Whatever comes, a block that is taken has a higher number than all
   --  that its session has taken, and a session keeps its newest.
   procedure Nothing_Older_Is_Taken
     (Item  : in out URV.Seals.Seal;
      Block : in out Block_Data;
      Came  : Boolean;
      What  : out Outcome)
   with
     Global => null,
     Pre    => Item.Format = 2,
     Post   =>
       (if What = Opened
        then Item'Old.Active.Is_Present
          and then Item.Active.Newest > Item'Old.Active.Newest
          and then Item.Active =
            (Item'Old.Active with delta Newest => Item.Active.Newest)
        elsif What = Opened_Anew
        then Item'Old.Pending.Is_Present
          and then Item.Active.Newest > Item'Old.Pending.Newest
          and then Item.Active =
            (Item'Old.Pending with delta Newest => Item.Active.Newest)
        elsif What /= Hello_Taken
        then Item.Active = Item'Old.Active
          or else not Item.Active.Is_Present);

   --  What is refused changes nothing but the time since something opened.
   procedure What_Is_Refused_Changes_Nothing
     (Item  : in out URV.Seals.Seal;
      Block : in out Block_Data;
      What  : out Outcome)
   with
     Global => null,
     Post   =>
       (if What in Refused
        then Item = A_Frame_Later (Item'Old)
          and then (for all Each of Block => Each = 0));

   --  A session is begun with a nonce of this node that it goes past: the
   --  aircraft when it answers, the ground when it calls anew.
   procedure Own_Nonces_Are_Used_Once
     (Item  : in out URV.Seals.Seal;
      Block : in out Block_Data;
      What  : out Outcome)
   with
     Global => null,
     Pre    => Item.Format = 2,
     Post   =>
       (if What = Hello_Taken
        then
          (if Item.Role = Aircraft
           then Item.Pending.Aircraft_Nonce = Item.Own'Old
             and then Item.Own = Item.Own'Old + 1
           elsif Item.Active.Is_Present
           then Item.Active.Ground_Nonce = Item.Own
           else Item.Own = Item.Own'Old + 1)
        else Item.Own = Item.Own'Old
          and then Item.Pending.Aircraft_Nonce in
            Item.Pending.Aircraft_Nonce'Old | 0);

end Theorems.Seals;
