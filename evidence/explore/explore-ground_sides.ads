--  SPDX-License-Identifier: Apache-2.0

with Telemetry.Boards.Sides;

package Explore.Ground_Sides is
  new Telemetry.Boards.Sides (Telemetry.Ground);
