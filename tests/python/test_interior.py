# SPDX-License-Identifier: GPL-3.0-or-later
"""Stresses inside bodies against tables of an independent solution, closed forms, and what is refused."""

import csv
import warnings
from pathlib import Path

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact import interior
from mdrcontact._boundary import call, native

DATA = Path(__file__).parents[1] / "data"
STEEL, TIN = mdr.Elastic(210.0, 0.3), mdr.Elastic(450.0, 0.25)
CONTACT = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(TIN, 1.0, STEEL, "exact"))
STATE = CONTACT.at_radius(1.0)
DISPLACEMENTS, STRESSES = ("u_r", "u_t", "u_z"), ("s_rr", "s_tt", "s_zz", "s_rz", "s_rt", "s_tz")


def rows_of(name):
    lines = [line for line in (DATA / name).read_text().splitlines() if not line.startswith("#")]
    cases = {}
    for row in csv.DictReader(lines):
        cases.setdefault(row["case"], []).append(row)
    return cases


def body_of(words):
    *layers, base = words.split(";")
    stack = [(mdr.Elastic(E, nu), h) for h, E, nu in (map(float, layer.split(":")) for layer in layers)]
    substrate = mdr.RIGID if "rigid" in base else mdr.Elastic(*map(float, base.split(":")))
    return mdr.Layered(stack, substrate, "exact") if stack else mdr.Homogeneous(substrate)


def contact_of(row):
    a = float(row["a"])
    shapes = {"paraboloid R=1": mdr.Paraboloid(1.0), "flat": mdr.FlatPunch(a), "cone slope 1": mdr.Cone(np.pi / 4)}
    medium = body_of(row["body1"])
    if row["body2"] != "rigid":
        medium = mdr.Pair(medium, body_of(row["body2"]))
    contact = mdr.Contact(shapes[row["profile"]], medium, float(row["gamma"]))
    return contact, contact.at_depth(float(row["d"])) if row["profile"] == "flat" else contact.at_radius(a)


def largest_error(rows, state, field, names):
    """Relative to the largest displacement and stress of the state."""
    worst = 0.0
    for group in (DISPLACEMENTS, STRESSES):
        known = {
            name: np.array([float(row[names.get(name, name)]) for row in rows])
            for name in group
            if names.get(name, name) in rows[0]
        }
        size = max(np.abs(values).max() for values in known.values())
        for name, values in known.items():
            worst = max(worst, np.abs(getattr(field, name) - values).max() / size)
    return worst


def fields_at(contact, state, rows, **options):
    r, z = (np.array([float(row[name]) for row in rows]) for name in ("r", "z"))
    above = np.array([row["side"] == "-" for row in rows])
    options["body"] = "upper" if rows[0]["inside"] == "2" else "lower"
    both = [state.interior(r, z, side=side, **options) for side in ("below", "above")]
    return mdr.Interior(*(np.where(above, up, down) for down, up in zip(*both, strict=True)))


@pytest.mark.parametrize("case", rows_of("stress.csv"))
def test_rows_of_the_table(case):
    rows = rows_of("stress.csv")[case]
    contact, state = contact_of(rows[0])
    assert state.depth == pytest.approx(float(rows[0]["d"]), rel=1e-9)
    # the rows hold a rigid base's surface from above
    rigid = "rigid" in rows[0]["body1"]
    if rigid:
        r, z = (np.array([float(row[name]) for row in rows]) for name in ("r", "z"))
        field = state.interior(r, z, side="above")
    else:
        field = fields_at(contact, state, rows)
    assert largest_error(rows, state, field, {}) < 1e-9
    largest = max(float(row["von_mises"]) for row in rows)
    assert np.asarray(field.von_mises) == pytest.approx([float(row["von_mises"]) for row in rows], abs=1e-8 * largest)
    assert np.asarray(field.tresca) == pytest.approx([float(row["tresca_shear"]) for row in rows], abs=1e-8 * largest)


@pytest.mark.parametrize("case", rows_of("sliding.csv"))
def test_rows_of_the_sliding_table(case):
    rows = rows_of("sliding.csv")[case]
    contact, state = contact_of(rows[0])
    angle, names = 0.7, {"u_t": "u_phi", "s_tt": "s_pp", "s_rt": "s_rp", "s_tz": "s_pz"}
    still = fields_at(contact, state, rows)
    slid = fields_at(contact, state, rows, friction=1.0, angle=angle)
    factors = {name: np.sin(angle) if name in ("u_t", "s_rt", "s_tz") else np.cos(angle) for name in mdr.Interior._fields}
    field = mdr.Interior(*((getattr(slid, n) - getattr(still, n)) / factors[n] for n in mdr.Interior._fields))
    assert largest_error(rows, state, field, names) < 1e-9


def test_surface_values_are_those_of_the_contact():
    r = np.array([0.0, 0.4, 0.9, 1.3, 5.0])
    field = STATE.interior(r, 0.0)
    assert field.u_z == pytest.approx(STATE.displacement(r), rel=1e-9)
    assert field.s_zz[:3] == pytest.approx(-STATE.pressure(r[:3]), rel=1e-9)


def test_high_contrast_to_ten_digits():
    """Six equations a wavenumber in 80 digits (tests/data/stress_contrast.py) share nothing with the sweep."""
    rows = list(csv.DictReader((DATA / "stress_contrast.csv").read_text().splitlines()))
    assert len(rows) == 12
    for case in ("1e4", "1e-4"):
        points = [row for row in rows if row["contrast"] == case]
        nu, base, a = (float(points[0][name]) for name in ("nu_film", "nu_base", "a"))
        film = mdr.Coated(mdr.Elastic(2 * (1 + nu), nu), 1.0, mdr.Elastic(2 * (1 + base) / float(case), base))
        contact = mdr.Contact(mdr.Paraboloid(1.0), film)
        state = contact.at_radius(a)
        assert state.depth == pytest.approx(float(points[0]["depth"]), rel=1e-12)
        for names in (("u_r", "u_z"), ("s_rr", "s_tt", "s_zz", "s_rz")):
            largest = max(abs(float(row[name])) for row in points for name in names)
            for row in points:
                side = "below" if row["layer"] == "1" else "above"
                field = state.interior(float(row["r"]), float(row["z"]), side=side)
                for name in names:
                    assert getattr(field, name) == pytest.approx(float(row[name]), abs=1e-10 * largest), (row, name)


def test_adhesive_and_flat_edges_are_infinite():
    adhesive = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(TIN, 1.0, STEEL, "exact"), work_of_adhesion=1.0)
    state = adhesive.at_radius(1.0)
    field = state.interior(1.0, 0.0)
    assert field.s_zz == np.inf and field.von_mises == np.inf and np.isfinite(field.u_z)
    assert np.isfinite(state.interior(1.0, 1e-9).s_zz)
    with pytest.raises(mdr.MDRError, match="adhesion"):
        state.interior(0.5, 0.1, friction=0.2)
    cone = mdr.Contact(mdr.Cone(0.3), mdr.Homogeneous(STEEL))
    assert cone.at_radius(1.0).interior(0.0, 0.0).s_zz == -np.inf


@pytest.mark.parametrize("angle", [0.0, 0.5 * np.pi, 0.8, 2.5, np.pi])
@pytest.mark.parametrize("medium", [mdr.Homogeneous(STEEL), mdr.Coated(TIN, 0.7, STEEL)], ids=["homogeneous", "coated"])
def test_friction_at_a_flat_edge_has_the_infinities_of_both_sides(medium, angle):
    punch = mdr.Contact(mdr.FlatPunch(1.0), medium)
    state = punch.at_depth(0.01)
    options = {"friction": 0.3, "angle": angle}
    field = state.interior(1.0, 0.0, **options)
    inside, outside = (state.interior([1.0 + s * 1e-6, 1.0 + s * 1e-10], 0.0, **options) for s in (-1, 1))
    for name, value in field._asdict().items():
        limits = []
        for near in (inside, outside):
            values = getattr(near, name)
            # one over the square root of the distance: a hundred times larger there
            if abs(values[1]) > 50.0 * abs(values[0]) > 1e-9:
                limits.append(np.sign(values[1]) * np.inf)
        assert value == limits[0] if limits else np.isfinite(value), name


def test_friction_at_the_apex_of_a_cone_is_infinite():
    cone = mdr.Contact(mdr.Cone(0.3), mdr.Homogeneous(STEEL))
    state = cone.at_radius(1.0)
    field = state.interior(0.0, 0.0, friction=0.3, angle=[0.0, 0.8, np.pi])
    assert np.array_equal(field.s_rz, [-np.inf, -np.inf, np.inf])
    assert field.s_tz[1] == np.inf and field.s_tz[[0, 2]] == pytest.approx(0.0, abs=1e-12)
    for normal in (field.s_rr, field.s_tt, field.s_zz):
        assert np.all(normal == -np.inf)
    # along the surface and along the axis s_rt has different limits: it is given as that from below
    assert field.s_rt == pytest.approx(0.0, abs=1e-12) and np.all(np.isfinite(field.u_r))
    near = state.interior([0.0, 1e-9], [1e-9, 0.0], friction=0.3, angle=0.8).s_rt
    assert abs(near[0]) < 1e-9 * abs(near[1])


def test_stresses_under_a_models_own_pressure():
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(TIN, 1.0, STEEL, "gao"))
    state = contact.at_radius(1.0)
    r = np.array([0.2, 0.7])
    assert state.interior(r, 0.0).s_zz == pytest.approx(-state.pressure(r), rel=1e-8)


def test_graded_body_of_equal_constants_is_homogeneous():
    graded = mdr.Contact(mdr.Paraboloid(1.0), mdr.Graded([0.0, 1.0], [210.0, 210.0], 0.3, "exact"))
    same = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(STEEL))
    r, z = np.array([0.0, 0.6, 1.5])[:, None], np.array([0.0, 0.3, 2.0])
    for found, expected in zip(graded.at_radius(1.0).interior(r, z), same.at_radius(1.0).interior(r, z), strict=True):
        assert found == pytest.approx(expected, abs=1e-9 * 210.0)


def test_graded_body_balances():
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Graded([0.0, 1.0, 2.0], [450.0, 300.0, 210.0], 0.3, "exact"))
    state = contact.at_radius(1.0)
    step, r, z = 0.02, 0.5, 0.6
    weights = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0.0, 4 / 5, -1 / 5, 4 / 105, -1 / 280]) / step
    offsets = step * np.arange(-4, 5)
    along = state.interior(r + offsets, z)
    down = state.interior(r, z + offsets)
    here = state.interior(r, z)
    assert weights @ along.s_rr + weights @ down.s_rz + (here.s_rr - here.s_tt) / r == pytest.approx(0.0, abs=1e-3)
    # Hooke with the modulus at this depth: E (u_r/r) = s_tt - nu (s_rr + s_zz)
    modulus = 450.0 - 150.0 * z
    assert here.s_tt - 0.3 * (here.s_rr + here.s_zz) == pytest.approx(modulus * here.u_r / r, rel=1e-9)


STEEP = {
    "1 to 30, a of 3": ([1.0, 30.0], 3.0),
    "30 to 1, a of 3": ([30.0, 1.0], 3.0),
    "1 to 100, a of 10": ([1.0, 100.0], 10.0),
    "100 to 1, a of 10": ([100.0, 1.0], 10.0),
}


@pytest.mark.parametrize("case", [pytest.param(name, marks=[pytest.mark.slow] * ("100" in name)) for name in STEEP])
def test_steep_gradients(case):
    """The surface against the contact, which integrates other equations, and the balance of forces."""
    moduli, a = STEEP[case]
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Graded([0.0, 1.0], moduli, 0.3, "exact"))
    state = contact.at_radius(a)
    r = a * np.array([0.0, 0.2, 0.6, 0.9, 0.99, 1.0, 1.01, 1.5, 3.0])
    field = state.interior(r, 0.0)
    assert np.abs(field.u_z - state.displacement(r)).max() < 1e-9 * state.depth
    pressure = np.asarray(state.pressure(r[:6]))
    assert np.abs(field.s_zz[:6] + pressure).max() < 1e-9 * pressure.max()
    # stresses and displacements go on smoothly from the surface to below it
    below = state.interior(r[:4], 1e-11 * a)
    for name in ("u_r", "u_z", "s_rr", "s_tt", "s_zz", "s_rz"):
        size = state.depth if name[0] == "u" else pressure.max()
        assert np.abs(getattr(below, name) - getattr(field, name)[:4]).max() < 1e-8 * size
    # what passes the bottom and the side of a cylinder around the contact
    x, w = np.polynomial.legendre.leggauss(16)
    side, z = 2.0 * a, min(0.5 * a, 0.9)
    edges = a * np.concatenate([[0.0], 1.0 - 0.5 ** np.arange(1, 5), [1.0, 1.25, 1.5, 2.0]])
    radii = (edges[:-1, None] + 0.5 * np.diff(edges)[:, None] * (1.0 + x)).ravel()
    weights = (0.5 * np.diff(edges)[:, None] * w).ravel()
    bottom = 2.0 * np.pi * np.sum(weights * radii * state.interior(radii, z).s_zz)
    depths = 0.5 * z * (1.0 + x)
    flank = 2.0 * np.pi * side * np.sum(0.5 * z * w * state.interior(side, depths).s_rz)
    assert -(bottom + flank) == pytest.approx(state.force, rel=1e-8)


def test_more_knots_of_the_same_line_change_nothing():
    few, many = [0.0, 1.0], [0.0, 0.01, 0.3, 0.5, 0.98, 1.0]
    r, z = np.array([0.0, 0.3, 1.0, 2.0])[:, None], np.array([0.0, 1e-6, 0.02, 0.3, 1.0, 3.0])
    fields = []
    for knots in (few, many):
        medium = mdr.Graded(knots, [1.0 + 29.0 * depth for depth in knots], 0.3, "exact")
        contact = mdr.Contact(mdr.Paraboloid(1.0), medium)
        fields.append(contact.at_radius(1.0).interior(r, z, friction=0.3, angle=0.7))
    for one, other in zip(*fields, strict=True):
        assert np.abs(np.asarray(one) - other).max() < 1e-10


@pytest.mark.parametrize(("r", "z"), [(0.6, 0.01), (0.5, 0.3), (1.3, 0.02)])
def test_sliding_on_a_graded_body_balances_and_obeys_hooke(r, z):
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Graded([0.0, 1.0], [1.0, 30.0], [0.2, 0.4], "exact"))
    state = contact.at_radius(1.0)
    step, angle = 0.05 * z, 0.7
    weights = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 0.0, 4 / 5, -1 / 5, 4 / 105, -1 / 280])
    places = np.arange(-4, 5)

    def field(r, z, angle):
        return state.interior(r, z, friction=0.4, angle=angle)

    along, down = field(r + step * places, z, angle), field(r, z + step * places, angle)
    around, here = field(r, z, angle + 0.05 * places), field(r, z, angle)
    d_r = {name: weights @ getattr(along, name) / step for name in along._fields}
    d_z = {name: weights @ getattr(down, name) / step for name in down._fields}
    d_t = {name: weights @ getattr(around, name) / 0.05 for name in around._fields}
    balance = [
        d_r["s_rr"] + d_t["s_rt"] / r + d_z["s_rz"] + (here.s_rr - here.s_tt) / r,
        d_r["s_rt"] + d_t["s_tt"] / r + d_z["s_tz"] + 2.0 * here.s_rt / r,
        d_r["s_rz"] + d_t["s_tz"] / r + d_z["s_zz"] + here.s_rz / r,
    ]
    assert np.abs(balance).max() < 1e-6
    inside = min(z, 1.0)
    nu = 0.2 + 0.2 * inside
    shear = 0.5 * (1.0 + 29.0 * inside) / (1.0 + nu)
    strain = d_r["u_r"], here.u_r / r + d_t["u_t"] / r, d_z["u_z"]
    volume = 2.0 * shear * nu / (1.0 - 2.0 * nu) * sum(strain)
    assert np.allclose([2.0 * shear * e + volume for e in strain], [here.s_rr, here.s_tt, here.s_zz], rtol=0.0, atol=1e-7)
    assert shear * (d_t["u_r"] / r + d_r["u_t"] - here.u_t / r) == pytest.approx(here.s_rt, abs=1e-7)
    assert shear * (d_z["u_r"] + d_r["u_z"]) == pytest.approx(here.s_rz, abs=1e-7)
    assert shear * (d_z["u_t"] + d_t["u_z"] / r) == pytest.approx(here.s_tz, abs=1e-7)


TIPS = [mdr.Paraboloid(1.0), mdr.Cone(0.3), mdr.Sphere(1.5), mdr.PowerLaw(30.0, 0.1), mdr.FlatEndedCone(0.5, 0.3),
        mdr.RoundedCone(1e-4, 0.3), mdr.AreaFunction([24.5, 0.003], max_height=100.0)]  # fmt: skip
SOFT = mdr.Elastic(1.0, 0.49)
MEDIA = [mdr.Homogeneous(STEEL), mdr.Coated(TIN, 0.7, STEEL), mdr.Coated(SOFT, 0.3, STEEL), mdr.Coated(SOFT, 0.5, mdr.RIGID),
         mdr.Coated(TIN, 0.7, STEEL, "gao"), mdr.Layered([(TIN, 0.2), (mdr.Elastic(50.0, 0.4), 0.4)], STEEL), mdr.Pair(STEEL, TIN),
         mdr.Pair(mdr.Coated(TIN, 0.7, STEEL), STEEL), mdr.Pair(mdr.Coated(TIN, 0.7, STEEL, "gao"), STEEL)]  # fmt: skip


def deviation(state, body="lower"):
    return call(native.load_interior_error, state._load, interior.BODIES[body])


@pytest.mark.parametrize("medium", MEDIA, ids=str)
@pytest.mark.parametrize("tip", TIPS, ids=lambda tip: type(tip).__name__)
def test_the_field_is_that_of_the_contact_on_the_surface(tip, medium):
    contact = mdr.Contact(tip, medium)
    for body in ("lower", "upper") if isinstance(medium, mdr.Pair) else ("lower",):
        assert deviation(contact.at_radius(1.0), body) < 1e-11


def test_gradients_too_steep_for_images_are_refused_near_the_surface():
    """Deeper the field is given, and not refused because there is nothing to compare it with."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Graded([0.0, 1e-6], [1e3, 1.0], 0.3, "gao"))
    state = contact.at_radius(1.0)
    with pytest.raises(mdr.errors.NoConvergenceError, match="too steeply. Use deeper points"):
        state.interior(0.3, 0.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        field = state.interior(np.linspace(0.0, 1.0, 1000), 0.5)
    same = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3)))
    expected = same.at_radius(1.0).interior(0.0, 0.5).s_zz * state.force / same.at_radius(1.0).force
    assert field.s_zz[0] == pytest.approx(expected, rel=1e-2)


def test_a_loose_tolerance_of_a_graded_body_is_seen():
    """Its kernel is interpolated more coarsely, the states inside are not."""
    moduli = [1.0, 100.0]
    for tolerance, least, most in ((1e-10, 0.0, 1e-9), (1e-3, 1e-6, 1e-4)):
        contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Graded([0.0, 1.0], moduli, 0.3, tolerance=tolerance))
        assert least <= deviation(contact.at_radius(1.0)) < most


@pytest.mark.parametrize("share", [1e-9, 1e-6, 1e-4])
def test_the_deviation_is_as_large_as_what_was_spoiled(share):
    """The depth of another state: u_z belongs to the load, d - f(r) to the depth."""
    for contact in (CONTACT, mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(STEEL))):
        state = contact.at_radius(1.0)
        assert deviation(state.replace(depth=state.depth * (1.0 + share))) == pytest.approx(share, rel=1e-3)


def test_a_field_that_deviates_warns_once_and_is_refused_beyond():
    medium = mdr.Coated(TIN, 1.0, STEEL)
    contact, r = mdr.Contact(mdr.Paraboloid(1.0), medium), np.linspace(0.0, 2.0, 1000)
    state = contact.at_radius(1.0)
    off, wrong = (state.replace(depth=state.depth * factor) for factor in (1.0 + 1e-6, 1.01))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        state.interior(r, 0.1)
        off.interior(r[:999], 0.1)
    with pytest.warns(mdr.errors.InteriorAccuracyWarning, match=r"an error of about 1\.0e-06") as seen:
        off.interior(0.3, 0.1)
        off.interior(r, 0.1)
    assert len(seen) == 1 and seen[0].filename == __file__
    for _ in range(2):
        with pytest.raises(mdr.errors.NoConvergenceError, match=r"an error of about 9\.9e-03"):
            wrong.interior(r, 0.1)
    # what a tolerance allows brings no warning
    loose = mdr.Contact(mdr.Paraboloid(1.0), mdr.Pair(mdr.Coated(TIN, 1.0, STEEL, tolerance=1e-6), STEEL))
    state = loose.at_radius(1.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        state.replace(depth=state.depth * (1.0 + 5e-6)).interior(r, 0.1)
    with pytest.warns(mdr.errors.InteriorAccuracyWarning):
        state.replace(depth=state.depth * (1.0 + 5e-5)).interior(r, 0.1)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"r": -0.1}, "r"),
        ({"z": -0.1}, "z"),
        ({"z": np.nan}, "z"),
        ({"body": "upper"}, "rigid"),
        ({"body": "middle"}, "body"),
        ({"side": "left"}, "side"),
        ({"friction": -0.1}, "friction"),
        ({"friction": np.nan}, "friction"),
        ({"angle": np.inf}, "angle"),
        ({"r": 1e14}, "1e12 contact radii"),
        ({"r": [0.1, 0.2], "z": [0.1, 0.2, 0.3]}, "shape"),
    ],
)
def test_bad_input_is_refused(options, words):
    with pytest.raises((mdr.MDRError, TypeError), match=words):
        STATE.interior(**{"r": 0.1, "z": 0.1, **options})


def test_media_without_elastic_constants_are_refused():
    for medium in (mdr.TabulatedMedium([1.0, 2.0, 3.0], [1.0, 1.1, 1.2]), mdr.PowerLawGraded(1.0, 1.0, 0.3, 0.3)):
        contact = mdr.Contact(mdr.Paraboloid(10.0), medium)
        with pytest.raises(mdr.MDRError, match="subsurface stresses"):
            contact.at_radius(1.5).interior(0.1, 0.1)


def test_largest_stresses_of_tin_on_steel():
    # in units of the mean pressure: surface tension and its place, interface shear and its place, von Mises in film and substrate
    mean = STATE.force / np.pi
    found = STATE.critical()
    assert found.surface.value / mean == pytest.approx(0.1615157, rel=1e-5)
    assert found.surface.r == pytest.approx(1.0)
    assert found.interfaces[0].shear.value / mean == pytest.approx(0.175386, rel=1e-4)
    assert found.interfaces[0].shear.r == pytest.approx(0.895, abs=0.01)
    assert found.layers[0].von_mises.value / mean == pytest.approx(0.9146, rel=1e-3)
    assert found.layers[1].von_mises.value / mean == pytest.approx(0.6054, rel=1e-3)
    # a stiff film bends: its ring of tension lies outside the edge
    wide = CONTACT.at_radius(3.0)
    ring = wide.critical().surface
    assert ring.value / (wide.force / np.pi / 9.0) == pytest.approx(0.27524, rel=1e-4)
    assert ring.r / 3.0 == pytest.approx(1.165, abs=0.005)
    # the layers together hold the work of the indenter
    forces = [CONTACT.at_depth(depth).force for depth in STATE.depth * 0.5 * (1.0 + np.polynomial.legendre.leggauss(20)[0])]
    work = STATE.depth * 0.5 * np.polynomial.legendre.leggauss(20)[1] @ forces
    assert sum(layer.energy for layer in found.layers) == pytest.approx(work, rel=1e-6)


def test_hertz_yields_where_it_is_known_to():
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(STEEL))
    state = contact.at_radius(0.1)
    largest = state.critical().layers[0].tresca
    assert largest.value / state.pressure(0.0) == pytest.approx(0.3100205020, rel=1e-6)
    assert largest.z == pytest.approx(0.04808645, rel=1e-3)


def test_first_failure_under_a_flat_punch():
    """One contact radius: stresses grow with the depth. The film yields at the edge, where they are infinite: no entry."""
    contact = mdr.Contact(mdr.FlatPunch(1.0), CONTACT.medium)
    failures = contact.first_failure({"von_mises": [50.0, 60.0], "interface_shear": [30.0], "tension": [None, 5.0]}, friction=0.1)
    assert [failure.mode for failure in failures].count("von_mises") == 1 and len(failures) == 3
    for failure in failures:
        field = failure.state.interior(failure.at.r, failure.at.z, side="above", friction=0.1, angle=failure.at.angle)
        measure = {
            "von_mises": field.von_mises,
            "interface_shear": np.hypot(field.s_rz, field.s_tz),
            "tension": field.principal[..., 0],
        }
        assert measure[failure.mode] == pytest.approx(failure.strength, rel=1e-9)
    # half the strength at half the force
    half = contact.first_failure({"interface_shear": [15.0]}, friction=0.1)[0]
    whole = next(failure for failure in failures if failure.mode == "interface_shear")
    assert half.state.force == pytest.approx(0.5 * whole.state.force, rel=1e-9)


def test_first_failure_is_where_a_strength_is_reached():
    failures = CONTACT.first_failure({"von_mises": [None, 60.0], "interface_shear": [30.0]}, largest_radius=3.0)
    assert [failure.mode for failure in failures] == ["von_mises", "interface_shear"]
    assert failures[0].state.force < failures[1].state.force
    again = failures[0].state.critical()
    assert again.layers[1].von_mises.value == pytest.approx(60.0, rel=1e-4)
    assert CONTACT.first_failure({"von_mises": [1e6, None]}, largest_radius=1.0) == ()
    numpys = CONTACT.first_failure({"von_mises": (None, np.float32(60.0))}, largest_radius=np.int64(3))
    assert numpys[0].state == failures[0].state
    for wrong in ({}, {"von_mises": [1.0]}, {"melt": [1.0]}, {"von_mises": [-1.0, None]}, {"von_mises": [None, None]}):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="strengths"):
            CONTACT.first_failure(wrong)
    for wrong in ([1.0], {"von_mises": 1.0}, {"von_mises": "60"}, {"von_mises": ["60", None]}):
        with pytest.raises(mdr.errors.ArgumentTypeError, match="strengths"):
            CONTACT.first_failure(wrong)


def test_wrong_strengths_and_friction_are_refused_by_name():
    for options, words in (
        (
            {"strengths": {"von_mises": [None, np.nan]}},
            "strengths: 'von_mises': value = NaN: it must be finite and greater",
        ),
        ({"strengths": {"interface_shear": [-3.0]}}, "strengths: 'interface_shear': value = -3:"),
        ({"friction": -0.1}, "friction = -0.1: it must be finite and at least 0"),
        ({"body": "upper"}, "body"),
        ({"largest_radius": 0.0}, "largest_radius = 0.0:"),
        ({"largest_radius": -1.0}, "largest_radius = -1:"),
    ):
        with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
            CONTACT.first_failure(**{"strengths": {"von_mises": [None, 60.0]}, **options})
    with pytest.raises(mdr.errors.InvalidArgumentError, match="friction = -0.1:"):
        STATE.critical(friction=-0.1)
    graded = mdr.Contact(mdr.Paraboloid(1.0), mdr.Graded([0.0, 1.0], [1.0, 2.0], [0.3, 0.3]))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="a graded body has no layers"):
        graded.at_radius(0.1).critical()


def test_what_fails_at_once_is_said_so():
    """Under a cone stresses do not tend to 0 with the load: a film that does not bear them is not safe."""
    contact = mdr.Contact(mdr.Cone(0.2), CONTACT.medium)
    failures = contact.first_failure({"von_mises": [14.0, 2.0]}, largest_radius=3.0)
    assert [(failure.place, failure.at_once) for failure in failures] == [(0, True), (1, False)]
    # where stresses are infinite nothing is looked for nearer than 1e-3 a
    state = contact.at_radius(0.5)
    apex = state.critical().layers[0].von_mises
    assert np.hypot(apex.r, apex.z) == pytest.approx(5e-4, rel=1e-2)
    assert apex.value == pytest.approx(state.interior(apex.r, apex.z).von_mises, rel=1e-12)


def test_first_failure_under_a_flat_end():
    """Contact begins at the radius of the end."""
    contact = mdr.Contact(mdr.FlatEndedParaboloid(0.5, 50.0), mdr.Homogeneous(STEEL))
    (failure,) = contact.first_failure({"von_mises": [2.0]}, largest_radius=3.0)
    assert failure.state.radius > 0.5 and not failure.at_once
    assert failure.state.critical().layers[0].von_mises.value == pytest.approx(2.0, rel=1e-4)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="larger than the flat end"):
        contact.first_failure({"von_mises": [2.0]}, largest_radius=0.4)


def test_the_edge_of_an_adhesive_contact_is_no_failure():
    contact = mdr.Contact(mdr.Paraboloid(100.0), CONTACT.medium, work_of_adhesion=1e-3)
    failures = contact.first_failure({"von_mises": [14.0, 2.0]}, largest_radius=3.0)
    assert [failure.place for failure in failures] == [1] and not failures[0].at_once


@pytest.mark.parametrize("gap", [1e-3, 1e-5, 1e-7])
def test_energies_under_a_ball_hardly_larger_than_its_contact(gap):
    """The line load varies as the logarithm of the distance from the radius of the ball."""
    contact = mdr.Contact(mdr.Sphere(1.0), mdr.Coated(mdr.Elastic(3.0, 0.3), 0.1, mdr.Elastic(1.0, 0.3)))
    state = contact.at_radius(1.0 - gap)
    energy = sum(layer.energy for layer in state.critical().layers)
    assert energy == pytest.approx(state.energy(), rel=1e-10)


def test_points_too_far_away_for_layers_are_refused():
    """Their waves would be gigabytes, and a list of their panels ended the process."""
    contact = mdr.Contact(mdr.Sphere(10.0), mdr.Coated(mdr.Elastic(3.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3)))
    state = contact.at_radius(1.0)
    near, far = (float(state.interior(r, 2.0).u_z) for r in (1e3, 1e4))
    assert near / far == pytest.approx(10.0, rel=0.01)
    for r in (1e6, 1e9, 1e12):
        with pytest.raises(mdr.MDRError, match=r"points at this distance need .* waves, and the limit is 1e\+06"):
            state.interior(r, 2.0)


def test_displacements_far_away_are_those_of_a_point_load():
    """At any distance, in little time and memory: u = F/(pi E* r) of the base."""
    film, base = mdr.Elastic(3.0, 0.3), mdr.Elastic(1.0, 0.3)
    for medium in (mdr.Coated(film, 1.0, base), mdr.Graded([0.0, 0.5, 1.0], [3.0, 2.0, 1.0], 0.3, model="exact")):
        contact = mdr.Contact(mdr.Sphere(10.0), medium)
        state = contact.at_radius(1.0)
        r = np.array([1e7, 1e14, 1e16, 1e100, 1e300])
        expected = state.force * (1.0 - 0.3**2) / (np.pi * r)
        assert state.displacement(r) / expected == pytest.approx(np.ones(5), rel=1e-6)


def sharp_tips():
    hyperboloid = mdr.AreaFunction([24.5, 0.003], max_height=100.0)
    return {
        "worn by 3e-3": hyperboloid,
        "with a root term": mdr.AreaFunction([24.5, 0.0, 0.05], max_height=100.0),
        "Berkovich, C1 of 300 nm": mdr.AreaFunction([24.5, 0.3], max_height=100.0),
        "power 30": mdr.PowerLaw(30.0, 1.0),
        "power 2.3": mdr.PowerLaw(2.3, 1.0),
        "cone": mdr.Cone(0.3),
        "rounded cone": mdr.RoundedCone(0.3, 0.003),
    }


@pytest.mark.parametrize("tip", sharp_tips())
@pytest.mark.parametrize("thickness", [None, 0.02, 0.005])
def test_surface_fits_tips_whose_load_varies_beside_the_axis(tip, thickness):
    """The pressure by (6) and the shape of the indenter know nothing of the rules of the stresses."""
    base = mdr.Elastic(1.0, 0.3)
    medium = mdr.Homogeneous(base) if thickness is None else mdr.Coated(mdr.Elastic(10.0, 0.2), thickness, base)
    contact = mdr.Contact(sharp_tips()[tip], medium)
    state = contact.at_radius(1.0)
    r = np.array([0.0, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.9, 0.999])
    field = state.interior(r, 0.0)
    heights = np.asarray(contact.indenter.height(r))
    assert np.abs(field.u_z - (state.depth - heights)).max() < 1e-10 * state.depth
    pressure = state.pressure(r)
    finite = np.isfinite(pressure)
    assert np.array_equal(finite, np.isfinite(field.s_zz))
    assert np.abs(field.s_zz[finite] + pressure[finite]).max() < 1e-10 * pressure[finite].max()


KINKED = [mdr.Cone(0.3), mdr.PowerLaw(1.5, 0.3), mdr.PowerLaw(2.5, 0.3), mdr.RoundedCone(0.3, 0.05), mdr.FlatEndedCone(0.2, 0.3)]
"""Tips whose springs' displacement by the layers of a graded body falls too slowly as a series."""


@pytest.mark.slow
@pytest.mark.parametrize("moduli", [(1.0, 30.0), (30.0, 1.0)])
@pytest.mark.parametrize("tip", KINKED, ids=lambda tip: type(tip).__name__ + str(getattr(tip, "exponent", "")))
def test_kinked_tips_on_graded_bodies(tip, moduli):
    """The field on the surface, by waves in layers, against the contact, by its line; the energy against the work done."""
    contact = mdr.Contact(tip, mdr.Graded([0.0, 1.0], moduli, 0.3))
    state = contact.at_radius(1.0)
    r = np.array([0.0, 0.1, 0.31, 0.62, 0.9, 0.99, 1.0001, 1.1, 1.5, 3.0])
    field, pressure = state.interior(r, 0.0), state.pressure(r[1:6])
    assert np.abs(field.u_z - state.displacement(r)).max() < 1e-9 * state.depth
    assert np.abs(field.s_zz[1:6] + pressure).max() < 1e-9 * pressure.max()
    # int F dd from a smaller contact, beyond all kinks: differences of d(a), Gauss and Legendre over a
    x, w = np.polynomial.legendre.leggauss(12)
    a = 0.7 + 0.3 * x
    before, after = (contact.at_radius(a * (1.0 + k * 1e-3)).depth for k in (-1, 1))
    two_before, two_after = (contact.at_radius(a * (1.0 + k * 1e-3)).depth for k in (-2, 2))
    slope = (8.0 * (after - before) - (two_after - two_before)) / (12e-3 * a)
    gained = state.energy() - contact.at_radius(0.4).energy()
    assert 0.3 * np.sum(w * contact.at_radius(a).force * slope) == pytest.approx(gained, rel=1e-6)


@pytest.mark.parametrize("young", [(1.0, 30.0), (100.0, 1.0), (3.9, 0.35)])
def test_pressures_of_graded_bodies_beside_the_axis(young):
    contact = mdr.Contact(mdr.PowerLaw(3.0, 0.3), mdr.Graded([0.0, 0.84], young, 0.42))
    state = contact.at_radius(0.4)
    r = 0.4 * np.array([0.0, 1e-12, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 0.1])
    p = np.asarray(state.pressure(r))
    assert np.max(np.abs(p + state.interior(r, 0.0).s_zz)) < 1e-8 * p.max()
