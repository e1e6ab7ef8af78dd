--  SPDX-License-Identifier: Apache-2.0

with Ada.Command_Line; use Ada.Command_Line;

with Host.Complaints; use Host.Complaints;
with Host.Ground_Orders;
with Host.Option_Help;
with Sim.Conditions;
with Sim.Faults;

package body Sim.Commands is

   With_Help : constant String := "fly, items, numbers, tables";
   All_Names : constant String := With_Help & ", help, --version";

   --  The command of that name, or Help if there is none.
   function Command_Of (Name : String) return Command is
     (if Name = "fly" then Fly
      elsif Name = "items" then Items
      elsif Name = "numbers" then Numbers
      elsif Name = "tables" then Tables
      elsif Name = "--version" then Version
      else Help);

   procedure Refuse_Command (Name : String; Names : String) with No_Return;

   --  Refuses arguments after this number.
   procedure Expect_No_More (Than : Positive);

   procedure Refuse_Command (Name : String; Names : String) is
   begin
      Refuse ("unknown command " & Quoted (Name) & "; there are " & Names);
   end Refuse_Command;

   procedure Expect_No_More (Than : Positive) is
   begin
      if Argument_Count > Than then
         Refuse ("unexpected argument " & Quoted (Argument (Than + 1)));
      end if;
   end Expect_No_More;

   function Parsed return Call is
      Result : Call;
   begin
      if Argument_Count = 0 then
         Refuse ("no command; there are " & All_Names);
      end if;

      Result.Order := Command_Of (Argument (1));
      case Result.Order is
         when Fly =>
            Result.Chosen := Host.Options.Parsed (Host.Options.URV_Sim, 2);
            if Result.Chosen.Wants_Help then
               Result.Order := Help;
               Result.About := Fly;
            end if;
         when Items | Numbers | Tables | Version =>
            Expect_No_More (Than => 1);
         when Help =>
            if Argument (1) not in "help" | "--help" | "-h" then
               Refuse_Command (Argument (1), All_Names);
            elsif Argument_Count > 1 then
               Expect_No_More (Than => 2);
               if Command_Of (Argument (2))
                 not in Fly | Items | Numbers | Tables
               then
                  Refuse_Command (Argument (2), With_Help);
               end if;
               Result.About := Command_Of (Argument (2));
            end if;
      end case;
      return Result;
   end Parsed;

   procedure Print_Usage
     (To    : in out Text_Output.Writer;
      About : Command)
   is
      procedure Put (Line : String);

      procedure Put_Commands;
      procedure Put_Fly;
      procedure Put_Items;
      procedure Put_Numbers;
      procedure Put_Tables;

      procedure Put (Line : String) is
      begin
         Text_Output.Put_Line (To, Line);
      end Put;

      procedure Put_Commands is
      begin
         Put ("urv_sim: both nodes, the link between them and the aircraft,");
         Put ("in virtual time");
         Put ("");
         Put ("  urv_sim fly [options]   a flight, from files and to files");
         Put ("  urv_sim items           the table of items, as CSV");
         Put ("  urv_sim numbers         times and lengths, as JSON");
         Put ("  urv_sim tables          names and lengths for the ground,");
         Put ("                          as JSON");
         Put ("  urv_sim help [COMMAND]  this text, or its part about fly,");
         Put ("                          items, numbers or tables");
         Put ("  urv_sim --version       the program's version");
         Put ("");
      end Put_Commands;

      procedure Put_Fly is
      begin
         Put ("options of fly (--option VALUE or --option=VALUE)");
         Host.Option_Help.Print (To, Host.Options.URV_Sim);
         Put ("An output named - is standard output; the summary for people");
         Put ("then goes to standard error.");
         Put ("");
         Put ("faults, one a line; # starts a comment");
         for Kind in Faults.Fault_Kind loop
            Put ("  " & Faults.Form_Of (Kind));
         end loop;
         Put ("");
         Put ("conditions, one a line; # starts a comment");
         for Kind in Conditions.Condition_Kind loop
            Put ("  " & Conditions.Form_Of (Kind));
         end loop;
         Put ("");
         Put ("orders, one a line; # starts a comment");
         for Kind in Ground_Orders.Order_Kind loop
            Put ("  " & Ground_Orders.Form_Of (Kind));
         end loop;
         Put ("");
         Put ("exit status: 0 flown, 1 an output cannot be written or an");
         Put ("internal fault, 2 bad command line or bad input file");
         Put ("(FILE:LINE: error), 130 interrupted");
      end Put_Fly;

      procedure Put_Items is
      begin
         Put ("items prints a line for each word of the uplink, the");
         Put ("downlink, the PWM board and the laws' row: name, buffer,");
         Put ("position, unit, the values of words 0 and 4095, the limits");
         Put ("of warnings and cautions, the value of one word step, and the");
         Put ("word for zero");
      end Put_Items;

      procedure Put_Numbers is
      begin
         Put ("numbers prints the constants that scripts about a flight");
         Put ("need: the lengths of a tick, a frame, a conversion and a");
         Put ("character on the link in us, the numbers of words in the");
         Put ("buffers and of characters in the messages");
      end Put_Numbers;

      procedure Put_Tables is
      begin
         Put ("tables prints the lists that the ground shares with the");
         Put ("flight software: kinds of errors, words of the status, modes");
         Put ("of the laws, surfaces, and the layout of the frame packet");
      end Put_Tables;

   begin
      case About is
         when Help | Version =>
            Put_Commands;
            Put_Fly;
            Put ("");
            Put_Items;
            Put ("");
            Put_Numbers;
            Put ("");
            Put_Tables;
            Put ("");
            Put ("docs/urv_sim.md has details and examples");
         when Fly =>
            Put_Fly;
         when Items =>
            Put_Items;
         when Numbers =>
            Put_Numbers;
         when Tables =>
            Put_Tables;
      end case;
   end Print_Usage;

end Sim.Commands;
