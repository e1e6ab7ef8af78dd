--  SPDX-License-Identifier: Apache-2.0

--  The tasks of the run-time system. It has none, but the compiler refers to
--  this constant in each protected type.

package System.Tasking with Pure is
   Unspecified_Priority : constant Integer := -1;
end System.Tasking;
