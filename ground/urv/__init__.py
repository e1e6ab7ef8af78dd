# SPDX-License-Identifier: Apache-2.0
"""The ground station: what bin/urv runs."""
