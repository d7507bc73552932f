# SPDX-License-Identifier: GPL-3.0-or-later
"""Relations that hold for every input, over random inputs: one file for each capability.

`harness.py` says what a relation is, `draws.py` what is drawn, `references.py` has the quadratures and closed forms that share
nothing with the library. `tools/relations.py` draws as many as wanted, elsewhere each time.
"""
