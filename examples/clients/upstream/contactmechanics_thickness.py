# SPDX-License-Identifier: GPL-3.0-or-later
"""ContactMechanics: a bonded layer with poisson = 0.5 divides by zero; in one direction the thickness is ignored."""

import ContactMechanics
import numpy as np

try:
    ContactMechanics.PeriodicFFTElasticHalfSpace((8, 8), 1.0, (1.0, 1.0), thickness=0.1, poisson=0.5)
except ZeroDivisionError as problem:
    print(f"found: {problem!r}; expected: C(0) = 0")
layer = ContactMechanics.PeriodicFFTElasticHalfSpace((8,), 1.0, (1.0,), thickness=0.1, poisson=0.3)
deep = ContactMechanics.PeriodicFFTElasticHalfSpace((8,), 1.0, (1.0,), poisson=0.3)
same = np.array_equal(layer.greens_function, deep.greens_function)
print(f"found: a layer and a half-space have equal kernels in one direction: {same}; expected: False, or an error")
