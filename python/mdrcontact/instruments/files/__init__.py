# SPDX-License-Identifier: GPL-3.0-or-later
"""From a file of measurements, and what [data], [instrument] and [fit] of a problem file say of it, to data of a fit."""
