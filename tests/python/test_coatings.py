# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers that are not isotropic, interfaces that give, and stress in a layer: against truth values, limits and each other."""

from __future__ import annotations

import csv
import math
import re

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact import problem

WAVES = np.geomspace(1e-6, 20.0, 60)
LOADS = ("normal", "shear", "twist")
GAN = mdr.TransverselyIsotropic(C11=390.0, C12=145.0, C13=106.0, C33=398.0, C44=105.0)
ENGINEERED = mdr.TransverselyIsotropic.from_engineering(1.0, 1.4, 0.3, 0.25, 0.5)
GRAPHITE = mdr.TransverselyIsotropic(C11=1060.0, C12=180.0, C13=15.0, C33=36.5, C44=4.5)
SHEET = mdr.Coated(GAN, 1.0, mdr.SMOOTH)
CONTACT = mdr.Contact(mdr.Paraboloid(2.0), mdr.Coated(GAN, 1.0, mdr.Elastic(130.0, 0.28)))
RECORD = mdi.ForceDepth([0.01, 0.02, 0.03], np.asarray(CONTACT.at_depth([0.01, 0.02, 0.03]).force), relative_sd=0.01)


def rows(name):
    lines = (ROOT / "tests" / "data" / name).read_text().splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def numbers(text):
    return {name.strip(): float(value) for name, value in (pair.split("=") for pair in text.split(","))}


def material(text):
    kind, given, stress = re.fullmatch(r"(\w+)\(([^)]*)\)(?:\[sig0=([^\]]*)\])?", text.strip()).groups()
    made = mdr.TransverselyIsotropic(**numbers(given)) if kind == "TI" else mdr.Elastic(**numbers(given))
    return made, float(stress or 0.0)


def interface(text):
    if text in ("bonded", "smooth"):
        return None
    if text == "slide":
        return mdr.SLIDING
    springs = numbers(re.fullmatch(r"springs\((.*)\)", text).group(1))
    normal, tangential = (None if math.isinf(springs[name]) else springs[name] for name in ("Kn", "Kt"))
    return mdr.Interface(normal=normal, tangential=tangential)


def body(layers, base, **options):
    if layers.strip() == "-":
        return mdr.Homogeneous(material(base)[0])
    stack = []
    for text in layers.split(";"):
        inside, below = (part.strip() for part in text.split("|"))
        thickness, made = inside.split(" x ", 1)
        made, stress = material(made)
        stack.append(mdr.Layer(made, float(thickness), stress, interface(below)))
    words = {"rigid": mdr.RIGID, "smooth": mdr.SMOOTH}
    return mdr.Layered(stack, words[base.strip()] if base.strip() in words else material(base)[0], **options)


def test_compliances_are_those_of_another_solver():
    """To 1e-14: along the wave, across it, and under a pressure; a smooth base and sliding sheets included."""
    worst = 0.0
    for row in rows("coatings_compliance.csv"):
        medium = body(row["layers_top_first(h x material | interface below)"], row["base"])
        k = float(row["k"])
        normal, shear, across = (k * float(medium.compliance(k, load)) for load in LOADS)
        along = 2.0 * shear - across
        for found, name in ((normal, "kC_n"), (along, "kC_L"), (across, "kC_T")):
            if row[name] not in ("", "inf"):
                worst = max(worst, abs(found / float(row[name]) - 1.0))
    assert worst < 1e-14


@pytest.mark.filterwarnings("ignore::mdrcontact.MDRWarning")
def test_states_are_those_of_another_solver():
    """d, F, E_eff and k_t of paraboloids, cones and flat punches, without adhesion and with it, to 1e-12."""
    worst = 0.0
    media = {}
    for row in rows("coatings.csv"):
        # the film on rubber at a/h = 3 is known to 1.3e-12
        tolerance = 1e-11 if row["case"] == "prestressed film on rubber" else 1e-12
        key = row["layers"], row["base"]
        options = {} if row["layers"] == "-" else {"tolerance": tolerance}
        medium = media.setdefault(key, body(*key, **options))
        a, work = float(row["a"]), float(row["gamma"] or 0.0)
        tip = {"paraboloid": mdr.Paraboloid(1.0), "cone": mdr.PowerLaw(1.0, 1.0), "flat": mdr.FlatPunch(a)}[row["profile"]]
        contact = mdr.Contact(tip, medium, work_of_adhesion=work)
        state = contact.at_depth(float(row["d"])) if row["profile"] == "flat" else contact.at_radius(a)
        pairs = [(state.depth, row["d"]), (state.force, row["F"]), (medium.modulus(a), row["E_eff"])]
        if row["k_t"]:
            pairs.append((medium.tangential_stiffness(a), row["k_t"]))
        worst = max([worst, *(abs(found / float(true) - 1.0) for found, true in pairs)])
    assert len(media) > 20
    assert worst < 1e-12


def random_material(rng, like=None):
    """Positive energy with a margin; now and then nearly incompressible, now and then stiff along one direction alone."""
    stiff = 10.0 ** rng.uniform(-3, 3)
    ratio, shear = 10.0 ** rng.uniform(-1.5, 1.5, 2)
    nu = rng.uniform(-0.5, 0.9)
    bound = math.sqrt((1.0 - nu) / (2.0 * ratio))
    return mdr.TransverselyIsotropic.from_engineering(stiff, stiff * ratio, nu, rng.uniform(-0.9, 0.95) * bound, stiff * shear)


def isotropic(E, nu):
    return mdr.TransverselyIsotropic.from_engineering(E, E, nu, nu, 0.5 * E / (1.0 + nu))


@pytest.mark.parametrize(("decades", "room"), [(1, 1e-13), (3, 1e-11)])
@pytest.mark.parametrize("seed", range(4))
def test_isotropic_constants_are_isotropic_materials(seed, decades, room):
    """Compliances within 1e-13 up to contrasts of 100 and within 1e-11 up to 1e6, contacts within ten times that."""
    rng = np.random.default_rng(seed)
    parts = [(10.0 ** rng.uniform(-decades, decades), rng.uniform(-0.5, 0.5), rng.uniform(0.2, 2.0)) for _ in range(3)]
    layers, (E, nu, _) = parts[:2], parts[2]
    plain = mdr.Layered([(mdr.Elastic(*c), h) for *c, h in layers], mdr.Elastic(E, nu))
    other = mdr.Layered([(isotropic(*c), h) for *c, h in layers], isotropic(E, nu))
    for load in LOADS:
        np.testing.assert_allclose(other.compliance(WAVES, load), plain.compliance(WAVES, load), rtol=room)
    for medium, twin in ((plain, other), (mdr.Homogeneous(mdr.Elastic(E, nu)), mdr.Homogeneous(isotropic(E, nu)))):
        a = [0.1, 1.0, 10.0]
        np.testing.assert_allclose(twin.modulus(a), medium.modulus(a), rtol=10.0 * room)
        np.testing.assert_allclose(twin.tangential_modulus(a), medium.tangential_modulus(a), rtol=10.0 * room)
        np.testing.assert_allclose(twin.torsional_stiffness(a), medium.torsional_stiffness(a), rtol=10.0 * room)


@pytest.mark.parametrize("seed", range(6))
def test_a_layer_in_two_is_one_layer_and_springs_are_in_series(seed):
    rng = np.random.default_rng(100 + seed)
    film, base = random_material(rng), random_material(rng)
    h, part = 10.0 ** rng.uniform(-1, 1), rng.uniform(0.1, 0.9)
    normal, tangential = 10.0 ** rng.uniform(-3, 3, 2)
    springs = mdr.Interface(normal=normal, tangential=tangential)
    whole = mdr.Layered([mdr.Layer(film, h, interface=springs)], base)
    # almost the same thickness, or the two parts are joined before they are computed
    split = mdr.Layered([mdr.Layer(film, part * h, prestress=1e-300), mdr.Layer(film, (1.0 - part) * h, interface=springs)], base)
    # an inner layer without thickness between two springs of twice the stiffness
    twice = mdr.Interface(normal=2.0 * normal, tangential=2.0 * tangential)
    series = mdr.Layered([mdr.Layer(film, h, interface=twice), mdr.Layer(film, 1e-13 * h, interface=twice)], base)
    k = WAVES / h
    for load in LOADS:
        true = whole.compliance(k, load)
        np.testing.assert_allclose(split.compliance(k, load), true, rtol=1e-11)
        np.testing.assert_allclose(series.compliance(k, load), true, rtol=1e-9)


def test_springs_tend_to_bonded_and_to_sliding_and_a_soft_layer_to_springs():
    def film(below):
        return mdr.Layered([mdr.Layer(GAN, 1.0, interface=below)], mdr.Elastic(130.0, 0.28)).compliance(k)

    # springs show at k ~ K/G
    k = np.geomspace(1e-2, 3.0, 30)
    for near, far, limit in ((1e6, 1e9, None), (1e-6, 1e-9, mdr.SLIDING)):
        off = [np.abs(film(mdr.Interface(tangential=K)) / film(limit) - 1.0).max() for K in (near, far)]
        assert off[1] < 1e-5
        assert 500.0 < off[0] / off[1] < 2000.0  # of first order
    off = []
    for t in (1e-3, 1e-4):
        # of a stiffness C/t that stays
        soft = mdr.Elastic(10.0 * t, 0.3)
        C33, C44 = soft.E * 0.7 / (1.3 * 0.4), soft.E / 2.6
        glued = mdr.Layered([(GAN, 1.0), (soft, t)], mdr.Elastic(130.0, 0.28)).compliance(k)
        springs = film(mdr.Interface(normal=C33 / t, tangential=C44 / t))
        off.append(np.abs(glued / springs - 1.0).max())
    assert off[1] < 1e-3
    assert 8.0 < off[0] / off[1] < 12.0


def test_a_film_in_tension_tends_to_a_membrane_on_a_plate():
    """tau = sigma_0 h, B = H h^3/12 and K_m = (H + sigma_0) h on an incompressible base, where K_m does nothing."""
    base = mdr.Elastic(1.0, 0.5)
    k = np.array([0.1, 1.0, 3.0])
    off = []
    for h in (1e-3, 1e-4):
        film = mdr.Layered([mdr.Layer(mdr.Elastic(1e3, 0.3), h, prestress=1.0)], base)
        C = mdr.Homogeneous(base).compliance(k)
        bending = 1e3 / (1.0 - 0.3**2) * h**3 / 12.0
        off.append(np.abs(film.compliance(k) * (1.0 / C + h * k**2 + bending * k**4) - 1.0).max())
    assert off[1] < 1e-4
    assert off[1] < 0.2 * off[0]


def test_biot_and_wrinkling():
    """Neo-Hookean rubber under equibiaxial compression is unstable at a stretch of 0.66614; a stiff film on rubber wrinkles at
    (E_f*/4) (3 E*/E_f*)^(2/3) and the wavelength 2 pi h (E_f*/(3 E*))^(1/3), Chen, Hutchinson 2004."""

    def rubber(stretch):
        p = stretch**-4.0
        moduli = mdr.TransverselyIsotropic.from_engineering(*neo_hookean(p))
        return mdr.Layered([mdr.Layer(moduli, 1.0, prestress=stretch**2 - p)], mdr.Elastic(1e3, 0.5))

    assert rubber(0.68).compliance(1.0) > 0.0
    # stable, and softer than any base
    assert rubber(0.66615).compliance(20.0) > 100.0 * rubber(0.68).compliance(20.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="unstable"):
        rubber(0.66613)
    plane = 1e4 / (1.0 - 0.3**2)
    half_space = 1.0 / (1.0 - 0.5**2)
    critical = plane / 4.0 * (3.0 * half_space / plane) ** (2.0 / 3.0)
    film = mdr.Elastic(1e4, 0.3)
    stiff = mdr.Layered([(film, 1e-3)], mdr.Elastic(1.0, 0.5))
    found = stiff.wrinkling()
    with pytest.raises(mdr.errors.InvalidArgumentError, match="layer = 1: it must be a whole number from 0 to 0"):
        stiff.wrinkling(1)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="bare surface"):
        stiff.replace(surface=mdr.Surface(tension=1.0)).wrinkling()
    assert found.stress == pytest.approx(-critical, rel=2e-3)
    assert found.wavelength == pytest.approx(2e-3 * math.pi * (plane / (3.0 * half_space)) ** (1.0 / 3.0), rel=2e-3)
    mdr.Layered([mdr.Layer(film, 1e-3, prestress=0.7 * found.stress)], mdr.Elastic(1.0, 0.5))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="wrinkles, at the wavelength 0.08"):
        mdr.Layered([mdr.Layer(film, 1e-3, prestress=1.0001 * found.stress)], mdr.Elastic(1.0, 0.5))
    # layer over plate theory, the figures of theory/surfaces.md (7.4)
    for ratio, true in ((1e2, 0.9931), (1e3, 0.99867), (1e4, 0.99972), (1e5, 0.99994)):
        body = mdr.Layered([(mdr.Elastic(ratio, 0.3), 1.0)], mdr.Elastic(1.0, 0.5))
        plane = ratio / (1.0 - 0.3**2)
        plate = plane / 4.0 * (3.0 * half_space / plane) ** (2.0 / 3.0)
        assert body.wrinkling().stress == pytest.approx(-true * plate, rel=2e-3), ratio


@pytest.mark.parametrize(
    ("constants", "base", "stress", "words"),
    [
        ((1.0, 1.0, 0.9, 0.1, 1.0), mdr.Elastic(10.0, 0.3), -0.5 / 1.9, r"C66 \+ prestress"),
        ((1.0, 1.0, 0.9, 0.1, 1.0), mdr.RIGID, -0.5 / 1.9, r"C66 \+ prestress"),
        ((10.0, 1.0, 0.2, 0.2, 0.05), mdr.Elastic(0.1, 0.3), -0.049988, "the stiffness of a surface of it"),
        ((1.0, 1.0, 0.3, 0.3, 1.0 / 2.6), mdr.Elastic(1.0, 0.3), -0.3308055, "the stiffness of a surface of it"),
    ],
)
def test_no_wrinkles_where_the_layer_itself_gives_way(constants, base, stress, words):
    """All short waves lose their stiffness at once: there is no wavelength to answer with."""
    film = mdr.TransverselyIsotropic.from_engineering(*constants)
    body = mdr.Layered([mdr.Layer(film, 1.0)], base)
    with pytest.raises(mdr.errors.UnreachableError, match=f"layer 1 has no wrinkling wavelength: .* {words}") as refused:
        body.wrinkling()
    assert float(str(refused.value).split("stress of ")[1].split()[0]) == pytest.approx(stress, rel=1e-6)
    mdr.Layered([mdr.Layer(film, 1.0, prestress=0.5 * stress)], base)


def test_a_buried_film_wrinkles_between_two_half_spaces():
    """A thin film far below the surface is a plate between two half-spaces, twice as stiff as one: (E_f*/4) (6 E*/E_f*)^(2/3), and
    2 pi h (E_f*/(6 E*))^(1/3); the depth does not matter. Nearer to the surface less stress does, down to that of one at it."""
    soft, stiff = mdr.Elastic(1.0, 0.5), mdr.Elastic(1e4, 0.3)
    plane, half_space = 1e4 / (1.0 - 0.3**2), 1.0 / (1.0 - 0.5**2)

    def body(depth, stress=0.0):
        return mdr.Layered([mdr.Layer(soft, depth), mdr.Layer(stiff, 0.1, prestress=stress)], soft)

    for depth in (20.0, 100.0, 1e4):
        found = body(depth).wrinkling(1)
        assert found.stress == pytest.approx(-plane / 4.0 * (6.0 * half_space / plane) ** (2.0 / 3.0), rel=5e-3)
        assert found.wavelength == pytest.approx(0.2 * math.pi * (plane / (6.0 * half_space)) ** (1.0 / 3.0), rel=5e-3)
    bare = mdr.Layered([(stiff, 0.1)], soft).wrinkling().stress
    assert body(1e-4).wrinkling(1).stress == pytest.approx(bare, rel=1e-3)
    assert found.stress < body(1.0).wrinkling(1).stress < bare
    with pytest.raises(mdr.errors.InvalidArgumentError, match="wrinkles, at the wavelength 7"):
        body(100.0, 1.01 * found.stress)


def neo_hookean(p):
    """Engineering constants of s44 = 1/p, s33 = 0, c = 1, H = 4 p, C66 = p: E_t = 3 p at nu_t = 1/2, nu_tz = 1/2."""
    return 3.0 * p, 3.0 * p, 0.5, 0.5, p


def test_stiffnesses_and_engineering_constants_are_one_material():
    E_t, E_z, nu_t, nu_tz, G_z = 10.0, 25.0, 0.2, 0.15, 3.0
    one = mdr.TransverselyIsotropic.from_engineering(E_t, E_z, nu_t, nu_tz, G_z)
    other = mdr.TransverselyIsotropic(one.C11, one.C12, one.C13, one.C33, one.C44)
    assert other.contact_modulus == pytest.approx(one.contact_modulus, rel=1e-14)
    assert other.tangential_modulus == pytest.approx(one.tangential_modulus, rel=1e-14)
    # a uniaxial stress along t: the compliance matrix has 1/E_t, -nu_t/E_t, -nu_tz/E_t
    stiffness = np.array([[one.C11, one.C12, one.C13], [one.C12, one.C11, one.C13], [one.C13, one.C13, one.C33]])
    np.testing.assert_allclose(np.linalg.inv(stiffness)[:, 0], [1.0 / E_t, -nu_t / E_t, -nu_tz / E_t], rtol=1e-13)
    assert np.linalg.inv(stiffness)[2, 2] == pytest.approx(1.0 / E_z, rel=1e-13)
    C11, C12, C13, C33, C44 = (getattr(GAN, name) for name in ("C11", "C12", "C13", "C33", "C44"))
    closed = 2.0 * math.sqrt((C11 * C33 - C13**2) / C11 / (1.0 / C44 + 2.0 / (math.sqrt(C11 * C33) + C13)))
    assert GAN.contact_modulus == pytest.approx(closed, rel=1e-14)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: mdr.TransverselyIsotropic(1.0, 2.0, 0.1, 1.0, 1.0), r"C12 = 2.* \|C12\| < C11"),
        (lambda: mdr.TransverselyIsotropic(2.0, 1.0, 2.0, 1.0, 1.0), r"C13 = 2.* 2 C13\^2 < C33"),
        (lambda: mdr.TransverselyIsotropic(2.0, 1.0, 0.1, 1.0, 0.0), "C44 = 0"),
        (lambda: mdr.TransverselyIsotropic(2.0, 1.0, 0.1, -1.0, 1.0), "C33 = -1"),
        (lambda: mdr.TransverselyIsotropic(2.0, 1.0, math.nan, 1.0, 1.0), "C13 = NaN"),
        (lambda: ENGINEERED.replace(C33=5.0), "C33: it follows from engineering"),
        (lambda: mdr.TransverselyIsotropic.from_engineering(1.0, 1.0, 1.0, 0.1, 1.0), "nu_t = 1: .* -1 < nu_t < 1"),
        (
            lambda: mdr.TransverselyIsotropic.from_engineering(1.0, 4.0, 0.3, 0.5, 1.0),
            r"nu_tz = 0.5.* 2 nu_tz\^2 E_z/E_t <= 1 - nu_t",
        ),
        (lambda: mdr.Interface(normal=0.0), "normal = 0.0: .* > 0"),
        (lambda: mdr.Interface(tangential=-1.0), "tangential = -1.0: .* >= 0"),
        (lambda: mdr.Layered([mdr.Layer(GAN, 1.0, prestress=math.nan)], GAN), "prestress = NaN"),
        (lambda: mdr.Layered([mdr.Layer(GAN, 1.0, prestress=-1e3)], GAN), "prestress = -1000.* unstable"),
        (lambda: mdr.Coated(GAN, 1.0, mdr.Elastic(1.0, 0.3), "gao"), "not isotropic, bonded and free of stress. Use one of exact"),
        (lambda: mdr.Layered([(GAN, 1.0)], mdr.Viscoelastic(1.0, [(1.0, 1.0)], 0.3)), "must be isotropic and stress-free"),
        (
            lambda: mdr.Layer(mdr.PowerLawRheology(1.0, 1.0, 0.2, 0.5), 1.0, prestress=1.0),
            "prestress: it must be 0 in a viscoelastic layer",
        ),
        (lambda: mdr.Layered([mdr.Layer(GAN, 1.0, interface=mdr.SLIDING)], mdr.SMOOTH), "base already slides"),
        (
            lambda: mdr.Layered([mdr.Layer(GAN, 1.0, interface=mdr.SLIDING)], GAN).tangential_modulus(1.0),
            "no tangential stiffness",
        ),
        (
            lambda: mdr.Friction(mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(GAN, 1.0, mdr.SMOOTH)), 0.3),
            "no tangential stiffness",
        ),
        (lambda: mdi.fit(RECORD, mdr.Paraboloid(2.0), CONTACT.medium, ["coating.E"]), "coating.E"),
    ],
)
def test_refusals_say_why(make, words):
    with pytest.raises(mdr.MDRError, match=words):
        make()


def test_energy_balance_and_inverses_on_a_weak_interface():
    """dF/dd is the stiffness, d(F) inverts F(d), and pull-off under force is a maximum: on a film that slides over springs."""
    below = mdr.Interface(normal=20.0, tangential=3.0)
    medium = mdr.Layered([mdr.Layer(GRAPHITE, 0.5, interface=below), (GAN, 1.0)], mdr.Elastic(70.0, 0.2))
    contact = mdr.Contact(mdr.Paraboloid(2.0), medium)
    d, step = 0.05, 1e-5
    low, here, high = (contact.at_depth(depth) for depth in (d - step, d, d + step))
    assert (high.force - low.force) / (2.0 * step) == pytest.approx(here.stiffness, rel=1e-7)
    assert contact.at_force(here.force).depth == pytest.approx(d, rel=1e-9)
    adhesive = mdr.Contact(mdr.Paraboloid(2.0), medium, work_of_adhesion=0.1)
    pull = adhesive.pull_off("force")
    assert pull.force < 0.0


PROBLEM = """
[indenter]
shape = "sphere"
radius = "10 um"
[medium]
type = "coated"
substrate = {substrate}
[medium.coating]
thickness = "500 nm"
{coating}
[compute]
depths = ["20 nm"]
"""


@pytest.mark.parametrize(
    ("coating", "substrate", "medium"),
    [
        ('material = "GaN"', '"ZnO"', lambda: mdr.Coated(NAMED["GaN"].material, 5e-7, NAMED["ZnO"].material)),
        (
            'E_t = "10 GPa"\nE_z = "25 GPa"\nnu_t = 0.2\nnu_tz = 0.15\nG_z_GPa = 3\nprestress = "-10 MPa"',
            '"rigid"',
            lambda: mdr.Layered(
                [mdr.Layer(mdr.TransverselyIsotropic.from_engineering(1e10, 2.5e10, 0.2, 0.15, 3e9), 5e-7, -1e7)], mdr.RIGID
            ),
        ),
        (
            'E = "70 GPa"\nnu = 0.3\ninterface = { normal = "20 GPa/um", tangential = "3e15 Pa/m" }',
            "{ E = '1 GPa', nu = 0.4 }",
            lambda: mdr.Layered(
                [mdr.Layer(mdr.Elastic(7e10, 0.3), 5e-7, interface=mdr.Interface(normal=2e16, tangential=3e15))],
                mdr.Elastic(1e9, 0.4),
            ),
        ),
        (
            'C11 = "390 GPa"\nC12 = "145 GPa"\nC13 = "106 GPa"\nC33 = "398 GPa"\nC44 = "105 GPa"\ninterface = "sliding"',
            "{ material = 'graphite' }",
            lambda: mdr.Layered([mdr.Layer(NAMED["GaN"].material, 5e-7, interface=mdr.SLIDING)], NAMED["graphite"].material),
        ),
    ],
)
def test_problem_files(tmp_path, coating, substrate, medium):
    file = tmp_path / "film.toml"
    file.write_text(PROBLEM.format(coating=coating, substrate=substrate))
    assert problem.load(file).medium == medium()


NAMED = mdr.CRYSTALS


def test_named_materials_say_where_their_constants_are_from():
    for name, (made, source) in mdr.CRYSTALS.items():
        assert made.contact_modulus > 1e9, name
        assert re.search(r" (19|20)\d\d, ", source), name
