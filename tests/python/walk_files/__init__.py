# SPDX-License-Identifier: GPL-3.0-or-later
"""Every key of every table of a problem file changes what the commands say, or is refused with words."""
