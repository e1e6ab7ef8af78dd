with Explore.Sides;
with Telemetry;

package Explore.Aircraft_Sides is new Explore.Sides (Telemetry.Aircraft);
