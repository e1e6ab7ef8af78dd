--  SPDX-License-Identifier: Apache-2.0

with Explore.Sides;
with Telemetry;

package Explore.Aircraft_Sides is new Explore.Sides (Telemetry.Aircraft);
