# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables in texts and spreadsheets, and force curves of AFMs, as instruments write them."""
