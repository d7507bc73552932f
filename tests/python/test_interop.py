# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiled laws in numba, JAX and PyTorch: the values of the law, derivatives against differences, and what they compile to."""

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact import interop
from mdrcontact.interop._generic import Branch

COAT = mdr.Coated(mdr.Elastic(72e9, 0.17), 1e-6, mdr.Elastic(160e9, 0.25), "exact")
BENDS = mdr.Coated(mdr.Elastic(500.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3), "exact")
LAWS = {
    "film": lambda: mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1e-5), COAT), 1e-7),
    "continued": lambda: mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1e-5), COAT), 1e-7, continue_beyond=True),
    "break": lambda: mdr.ContactLaw(mdr.Contact(mdr.RoundedCone(2e-7, 0.5), COAT), 1e-7),
    "flat end": lambda: mdr.ContactLaw(mdr.Contact(mdr.FlatPunch(1e-6), COAT), 1e-7),
    "adhesion": lambda: mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1e-5), COAT, work_of_adhesion=0.5), 1e-7),
}
pytestmark = pytest.mark.filterwarnings("ignore::mdrcontact.errors.BeyondRangeWarning")


@pytest.fixture(params=LAWS, scope="module")
def law(request):
    return LAWS[request.param]()


@pytest.fixture(params=["loading", "unloading"])
def branch(request):
    return request.param


def depths(law, count=2000):
    low, high = law.depth_range
    ends = law.arrays().intervals
    ends = np.r_[ends["lowest"], ends["highest"]]
    near = np.r_[np.nextafter(ends, -1.0), ends, np.nextafter(ends, 1.0)]
    some = np.r_[np.geomspace(1e-6 * high, high, count), np.linspace(low - high, high, count), near, 0.0]
    return np.r_[some[some <= high], 1.3 * high] if law._facts["continue_beyond"] else some[some <= high]


def to_the_last_digits(expected):
    return {"rtol": 1e-13, "atol": 1e-14 * np.abs(expected).max()}


def test_arrays_are_views_of_the_numbers(law):
    arrays = law.arrays()
    np.testing.assert_array_equal(arrays.buffer, law.buffer())
    assert all(np.shares_memory(part, arrays.buffer) for part in arrays[2:])
    last, highest = arrays.intervals[-1], arrays.head["highest"]
    assert highest == law.depth_range[1] == last["highest"]
    # one polynomial by hand: the middle of the first panel of the last interval
    y = 1.0 + 0.5 ** (last["bits"] + 1)
    u = (y - last["offset"]) / last["scale"]
    d = last["origin"] + last["side"] * u**2 if last["is_root"] else u
    panel = int(last["first_panel"])
    state = law.at_depth(d)
    np.testing.assert_allclose([state.force, state.radius, state.stiffness, law.energy(d)],
                               [part[panel][..., None].flat[0] for part in arrays[4:]], rtol=1e-12)  # fmt: skip


@pytest.mark.parametrize("quantity", ["force", "energy"])
def test_generic_evaluation(law, branch, quantity):
    evaluate = Branch(law, quantity, branch, np, np.asarray, np.asarray)
    d = depths(law)
    with np.errstate(invalid="ignore"):
        found = evaluate(d)
    expected = law.force(d, branch) if quantity == "force" else law.energy(d, branch)
    # next to pull-off the root is a straight line over 1e-18 of the range
    np.testing.assert_allclose(
        found, expected, rtol=1e-13, atol=1e-9 * np.abs(expected).max() if "adhesive" in repr(law) else 1e-15
    )


def test_unknown_quantity():
    with pytest.raises(mdr.errors.InvalidArgumentError, match="quantity = 'forse': did you mean 'force'"):
        Branch(LAWS["film"](), "forse", "loading", np, np.asarray, np.asarray)


def test_numba_has_the_bits_of_the_law(law, branch):
    numba = pytest.importorskip("numba")
    function = interop.numba_function(law, branch)

    @numba.njit
    def many(d):
        out = np.empty((2, d.size))
        for i in range(d.size):
            out[0, i], out[1, i] = function(d[i])
        return out

    d = depths(law)
    force, slope = many(d)
    assert force.tobytes() == law.force(d, branch).tobytes()
    assert slope.tobytes() == law.at_depth(d, branch).slope.tobytes()
    refused = np.array([np.nan, np.inf, -np.inf] + ([] if law._facts["continue_beyond"] else [2.0 * law.depth_range[1]]))
    assert np.isnan(many(refused)).all()


def differences(f, x, step):
    """f'(x) to the sixth order."""
    return sum(w * (f(x + i * step) - f(x - i * step)) for i, w in ((1, 0.75), (2, -0.15), (3, 1 / 60))) / step


def check_derivatives(value, slope, curvature, law):
    """First and second derivatives against differences, within a panel."""
    last = law.arrays().intervals[-1]
    low, high = last["lowest"], last["highest"]
    for d in low + (high - low) * np.array([0.31, 0.53, 0.77]):
        step = 1e-4 * (high - low)
        assert slope(d) == pytest.approx(differences(value, d, step), rel=1e-7)
        assert curvature(d) == pytest.approx(differences(slope, d, step), rel=1e-7)


def test_jax(law, branch):
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", True)
    force, energy = (interop.jax_function(law, quantity, branch) for quantity in ("force", "energy"))
    d = depths(law)
    expected = law.at_depth(d, branch)
    tolerance = to_the_last_digits(expected.force)
    np.testing.assert_allclose(jax.jit(force)(d), expected.force, **tolerance)
    np.testing.assert_allclose(jax.jit(jax.vmap(force))(d), expected.force, **tolerance)
    slope, curvature = jax.jit(jax.grad(force)), jax.jit(jax.hessian(force))
    check_derivatives(lambda x: float(force(x)), lambda x: float(slope(x)), lambda x: float(curvature(x)), law)
    regular = np.abs(expected.slope) < 1e3 * np.median(np.abs(expected.slope))
    np.testing.assert_allclose(jax.vmap(slope)(d[regular]), expected.slope[regular], rtol=1e-11, atol=1e-12)
    np.testing.assert_allclose(jax.vmap(jax.grad(energy))(d[regular]), expected.force[regular], rtol=1e-8,
                               atol=1e-8 * np.abs(expected.force).max())  # fmt: skip


def test_jax_in_single_precision():
    jax = pytest.importorskip("jax")
    jax.config.update("jax_enable_x64", False)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="jax_enable_x64"):
        interop.jax_function(LAWS["film"]())
    jax.config.update("jax_enable_x64", True)


def test_torch(law, branch):
    torch = pytest.importorskip("torch")
    force = interop.torch_function(law, branch=branch)
    d = depths(law)
    expected = law.at_depth(d, branch)
    tolerance = to_the_last_digits(expected.force)
    np.testing.assert_allclose(force(torch.as_tensor(d)).numpy(), expected.force, **tolerance)

    def at(function):
        return lambda x: float(function(torch.tensor(x, dtype=torch.float64)))

    slope, curvature = torch.func.grad(force), torch.func.grad(torch.func.grad(force))
    check_derivatives(at(force), at(slope), at(curvature), law)
    many = torch.func.vmap(slope)(torch.as_tensor(d[d > 0.1 * d.max()]))
    np.testing.assert_allclose(many.numpy(), law.at_depth(d[d > 0.1 * d.max()], branch).slope, rtol=1e-11)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="torch.float64"):
        force(torch.ones(3))
