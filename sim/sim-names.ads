--  What the items of the buffers are called in files: the promise of the
--  stick, sensor and record formats.

package Sim.Names is

   function Name (Item : Uplink_Item) return String;
   function Name (Item : Downlink_Item) return String;
   function Name (Item : PWM_Item) return String;
   function Name (Item : Link_Item) return String;
   function Name (Way : Direction) return String;

end Sim.Names;
