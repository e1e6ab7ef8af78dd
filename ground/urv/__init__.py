# SPDX-License-Identifier: Apache-2.0
"""The ground station, run by bin/urv."""
