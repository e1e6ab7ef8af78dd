--  SPDX-License-Identifier: Apache-2.0

--  The operating system calls of the partitions besides Ada's own run-time:
--  files as a serial line or a socket, waiting for either until a time,
--  signals, and the rights of a thread. Linux.

with Interfaces.C; use Interfaces.C;
with System;

package Partitions.System_Calls is

   --  -1 from any of them is an error; GNAT.OS_Lib.Errno says which.
   Failed : constant := -1;

   subtype File is int;
   Invalid : constant File := Failed;

   subtype Byte_Total is long;

   function Read
     (From : File; Buffer : System.Address; Length : size_t)
      return Byte_Total
   with Import, Convention => C, External_Name => "read";

   function Write
     (To : File; Buffer : System.Address; Length : size_t)
      return Byte_Total
   with Import, Convention => C, External_Name => "write";

   function Close (This : File) return int
   with Import, Convention => C, External_Name => "close";

   --  Waiting

   Input_Ready : constant short := 1;
   Hung_Up     : constant short := 16;

   type Poll_Request is record
      This   : File;
      Wanted : short;
      Found  : short;
   end record with Convention => C;

   type Time_Span is record
      Seconds     : long;
      Nanoseconds : long;
   end record with Convention => C;

   Universal_Time : constant := 0;

   function Read_Clock (Which : int; Now : out Time_Span) return int
   with Import, Convention => C, External_Name => "clock_gettime";

   function Poll
     (Requests : System.Address;
      Length   : unsigned_long;
      Limit    : Time_Span;
      Mask     : System.Address) return int
   with Import, Convention => C, External_Name => "ppoll";

   type Poll_Requests is array (Positive range <>) of Poll_Request
   with Convention => C;

   --  A file that becomes readable when it is written to.
   function Event_File (Initially : unsigned; Flags : int) return File
   with Import, Convention => C, External_Name => "eventfd";

   --  Sockets

   --  The input is empty.
   Would_Block     : constant := 11;

   Any_Family      : constant := 0;
   Datagram        : constant := 2;
   To_Listen       : constant := 1;
   Leave_There     : constant := 2;
   Dont_Wait       : constant := 16#40#;
   No_Signal       : constant := 16#4000#;

   type Address_Info is record
      Flags     : int := 0;
      Family    : int := Any_Family;
      Kind      : int := Datagram;
      Protocol  : int := 0;
      Length    : unsigned := 0;
      Where     : System.Address := System.Null_Address;
      Canonical : System.Address := System.Null_Address;
      Next      : access Address_Info;
   end record with Convention => C;

   --  0, or a number that Address_Error explains.
   function Get_Address
     (Host  : char_array;
      Port  : char_array;
      Hints : Address_Info;
      Found : out System.Address) return int
   with Import, Convention => C, External_Name => "getaddrinfo";

   procedure Free_Address (Found : System.Address)
   with Import, Convention => C, External_Name => "freeaddrinfo";

   --  The family, port and address that Bind and Connect take.
   type Address_Bytes is array (Positive range <>) of unsigned_char
   with Convention => C;

   Internet_4 : constant := 2;
   Internet_6 : constant := 10;

   --  Two connected sockets of this machine.

   Local_Family  : constant := 1;
   Stream        : constant := 1;
   Close_On_Exec : constant := 8#2_000_000#;

   type File_Pair is array (1 .. 2) of File with Convention => C;

   function Socket_Pair
     (Family, Kind, Protocol : int; Made : out File_Pair) return int
   with Import, Convention => C, External_Name => "socketpair";

   --  Another descriptor of the same file, which a new program inherits.
   function Duplicate (This : File) return File
   with Import, Convention => C, External_Name => "dup";

   function Socket (Family, Kind, Protocol : int) return File
   with Import, Convention => C, External_Name => "socket";

   function Bind
     (This : File; Where : System.Address; Length : unsigned) return int
   with Import, Convention => C, External_Name => "bind";

   function Connect
     (This : File; Where : System.Address; Length : unsigned) return int
   with Import, Convention => C, External_Name => "connect";

   function Receive
     (From   : File;
      Buffer : System.Address;
      Length : size_t;
      Flags  : int) return Byte_Total
   with Import, Convention => C, External_Name => "recv";

   function Send
     (To     : File;
      Buffer : System.Address;
      Length : size_t;
      Flags  : int) return Byte_Total
   with Import, Convention => C, External_Name => "send";

   --  The same, with the address of the other side: the longest is that of
   --  struct sockaddr_in6.

   type Socket_Address is array (1 .. 28) of unsigned_char
   with Convention => C;

   function Receive_From
     (From   : File;
      Buffer : System.Address;
      Length : size_t;
      Flags  : int;
      Sender : System.Address;
      Sender_Length : in out unsigned) return Byte_Total
   with Import, Convention => C, External_Name => "recvfrom";

   function Send_To
     (To     : File;
      Buffer : System.Address;
      Length : size_t;
      Flags  : int;
      Receiver : System.Address;
      Receiver_Length : unsigned) return Byte_Total
   with Import, Convention => C, External_Name => "sendto";

   --  Serial lines

   Read_Write     : constant := 2;
   No_Controlling : constant := 8#400#;
   Non_Blocking   : constant := 8#4000#;

   function Open (Name : char_array; Flags : int) return File
   with Import, Convention => C_Variadic_2, External_Name => "open";

   Exclusively  : constant := 2;
   Without_Wait : constant := 4;

   function Lock (This : File; How : int) return int
   with Import, Convention => C, External_Name => "flock";

   --  struct termios2: a speed may be any number.
   type Control_Characters is array (0 .. 18) of unsigned_char;

   type Line_Settings is record
      Input_Flags   : unsigned      := 0;
      Output_Flags  : unsigned      := 0;
      Control_Flags : unsigned      := 0;
      Local_Flags   : unsigned      := 0;
      Discipline    : unsigned_char := 0;
      Characters    : Control_Characters := (others => 0);
      Input_Speed   : unsigned      := 0;
      Output_Speed  : unsigned      := 0;
   end record with Convention => C;

   Get_Settings : constant := 16#802C_542A#;
   Set_Settings : constant := 16#402C_542B#;

   function Control
     (This : File; Request : unsigned_long; Settings : in out Line_Settings)
      return int
   with Import, Convention => C_Variadic_2, External_Name => "ioctl";

   Flush          : constant := 16#540B#;
   Flush_Received : constant := 0;
   Flush_Both     : constant := 2;

   function Control
     (This : File; Request, Value : unsigned_long) return int
   with Import, Convention => C_Variadic_2, External_Name => "ioctl";

   --  Signals

   Interrupt         : constant := 2;
   User_1            : constant := 10;
   User_2            : constant := 12;
   Terminate_Program : constant := 15;

   type Signal_Words is array (1 .. 16) of unsigned_long;
   type Signal_Set is record
      Words : Signal_Words := (others => 0);
   end record with Convention => C;

   procedure Add (To : in out Signal_Set; Signal : int)
   with Import, Convention => C, External_Name => "sigaddset";

   To_Block   : constant := 0;
   To_Unblock : constant := 1;

   function Set_Mask
     (How : int; To : Signal_Set; Former : System.Address) return int
   with Import, Convention => C, External_Name => "pthread_sigmask";

   function Wait_For (Any_Of : Signal_Set; Came : out int) return int
   with Import, Convention => C, External_Name => "sigwait";

   --  The largest delay with which the operating system may wake a thread
   --  created by this one, in order to wake several at once.
   Timer_Slack : constant := 29;

   function Set_Process
     (Operation : int; Value : unsigned_long) return int
   with Import, Convention => C_Variadic_1, External_Name => "prctl";

   --  The user of the program, and the dispatching of its threads.

   Root : constant := 0;

   function Effective_User return int
   with Import, Convention => C, External_Name => "geteuid";

   First_In_First : constant := 1;

   This_Thread : constant := 0;

   function Policy_Of (Thread : int) return int
   with Import, Convention => C, External_Name => "sched_getscheduler";

   --  In Linux the parameters hold only the priority.
   function Read_Priority (Thread : int; Priority : out int) return int
   with Import, Convention => C, External_Name => "sched_getparam";

   function Set_Policy
     (Thread : int; Policy : int; Priority : in out int) return int
   with Import, Convention => C, External_Name => "sched_setscheduler";

   --  Each structure that the system writes has the size of C's, in bytes.
   pragma Compile_Time_Error
     (Time_Span'Size /= 8 * 16
      or else Poll_Request'Size /= 8 * 8
      or else Address_Info'Size /= 8 * 48
      or else Line_Settings'Size /= 8 * 44
      or else Signal_Set'Size /= 8 * 128,
      "a record is not as long as its struct");

end Partitions.System_Calls;
