--  SPDX-License-Identifier: Apache-2.0

--  The ground's node in virtual time (KRN-1 to KRN-6, EXT-4).

pragma SPARK_Mode;

with URVOS.Virtual_Nodes;

package GSC.Virtual_Time is new URVOS.Virtual_Nodes (Software);
