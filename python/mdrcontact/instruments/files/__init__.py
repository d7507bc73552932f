# SPDX-License-Identifier: GPL-3.0-or-later
"""From a file of measurements, and the tables [data], [instrument] and [fit] of a problem file, to data of a fit."""
