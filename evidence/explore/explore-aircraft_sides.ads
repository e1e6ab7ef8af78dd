--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Boards.Sides;

package Explore.Aircraft_Sides is
  new Telemetry.Boards.Sides (Telemetry.Aircraft);
