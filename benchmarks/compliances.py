# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of what boundary-element codes take of a body: C(k) on a grid of waves, and the response of a pixel without neighbours.

In pairs of a forward and a backward FFT: of the grid for C(k) at its waves, of the doubled grid for the pixel.
"""

import time
from collections.abc import Callable

import numpy as np

import mdrcontact as mdr

BASE = mdr.Elastic(1.0, 0.3)
BODIES = {
    "half-space": mdr.Homogeneous(BASE),
    "film 10": mdr.Coated(mdr.Elastic(10.0, 0.3), 1.0, BASE),
    "anisotropic film": mdr.Coated(mdr.TransverselyIsotropic(3.4, 1.2, 1.0, 2.6, 0.8), 1.0, BASE),
    "20 layers": mdr.Layered([(mdr.Elastic(10.0 if i % 2 else 1.0, 0.3), 0.1) for i in range(20)], BASE),
    "graded": mdr.Graded([0.0, 1.0], [4.0, 1.0], [0.3, 0.3]),
}


def best(function: Callable[[], object], times: int = 3) -> float:
    """Shortest of some calls."""
    found = []
    for _ in range(times + 1):
        start = time.perf_counter()
        function()
        found.append(time.perf_counter() - start)
    return min(found[1:])


def pair_of_transforms(n: int) -> float:
    """Time of a pair of transforms of n x n numbers."""
    values = np.random.default_rng(1).random((n, n))
    return best(lambda: np.fft.irfft2(np.fft.rfft2(values), s=values.shape), 7)


def waves(n: int, pixel: float) -> np.ndarray:
    """Wavenumbers of a grid, without that of the mean."""
    k = np.hypot(2.0 * np.pi * np.fft.fftfreq(n, pixel)[:, None], 2.0 * np.pi * np.fft.rfftfreq(n, pixel))
    k[0, 0] = k[0, 1]
    return k


def main() -> None:
    pair = pair_of_transforms(512)
    print(f"pair of transforms of 512 x 512: {1e3 * pair:.1f} ms")
    print("body               C at the waves of 512 x 512   pixel on 256 x 256 (images, error), in pairs")
    for name, body in BODIES.items():
        k, x = waves(512, 0.05), 0.05 * (np.arange(256) - 128)
        in_waves = best(lambda k=k, body=body: body.compliance(k)) / pair
        at_pixels = best(lambda x=x, body=body: body.rectangle_response(x[:, None], x, 0.05)) / pair
        print(f"{name:18} {in_waves:10.1f} {at_pixels:28.1f} ({body.response_error():.0e})")


if __name__ == "__main__":
    main()
