--  SPDX-License-Identifier: Apache-2.0

--  The run-time system's tasks: there are none. The compiler refers to this
--  constant in each protected type.

package System.Tasking with Pure is
   Unspecified_Priority : constant Integer := -1;
end System.Tasking;
