# SPDX-License-Identifier: Apache-2.0
"""Stability and control derivatives from flight records (GND-61 to GND-64).

    from urv import flights
    from urv.identification import aircraft, analysis

    flight = flights.read("record.csv", lambda record: None)
    result = analysis.identify([flight], aircraft.read())
    result.axes["longitudinal"].derivatives["Cm_alpha"].value

Units in these modules: ft, s, rad, slug and lb. Forces and moments are along
the body axes, x forward, y right, z down. Surfaces are in the pilot's sense, as
in the record: the mean of both sides, positive to the right or nose up.
"""
