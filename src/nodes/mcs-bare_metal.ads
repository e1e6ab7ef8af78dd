--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's node on a bare machine (BRD-1).

pragma SPARK_Mode;

with URVOS.Bare_Nodes;

package MCS.Bare_Metal is new URVOS.Bare_Nodes (Software);
