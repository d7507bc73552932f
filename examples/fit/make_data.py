# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the curves of this folder: what an instrument would read on known films, with noise. python examples/fit/make_data.py"""

from __future__ import annotations

from pathlib import Path

import numpy as np

import mdrcontact as mdr

HERE = Path(__file__).resolve().parent
OXIDE, SILICON = mdr.Elastic(72e9, 0.17), mdr.Elastic(163e9, 0.22)
DIAMOND = mdr.Elastic(1141e9, 0.07)
RUBBER = mdr.Elastic(2e6, 0.49)


def write(name: str, header: str, *columns: np.ndarray) -> None:
    """A table with five digits, separated by commas, or by tabs in a .txt."""
    delimiter = "," if name.endswith(".csv") else "\t"
    np.savetxt(HERE / name, np.column_stack(columns), fmt="%.5g", delimiter=delimiter, header=header, comments="")


def sink_in(body: mdr.Medium, a: np.ndarray | float) -> np.ndarray:
    """h_s = sigma P/S at the edge of a contact, sigma that of a paraboloid on this body: 0.75 on a half-space."""
    state = mdr.Contact(mdr.Paraboloid(1.0), body).at_radius(a)
    return np.asarray((np.asarray(state.depth) - 0.5 * np.asarray(a) ** 2) * state.stiffness / state.force)


def main() -> None:
    """Writes all files."""
    random = np.random.default_rng(2014)

    # a sphere on an oxide, 1 % noise, the instrument's zero 1.5 nm too early
    contact = mdr.Contact(mdr.Sphere(10e-6), mdr.Coated(OXIDE, 500e-9, SILICON, "exact"))
    depth = np.linspace(1e-9, 100e-9, 120)
    force = np.asarray(contact.at_depth(depth).force) * (1.0 + 0.01 * random.standard_normal(depth.size))
    write("sphere_on_oxide.csv", "depth [nm],load [mN]", (depth + 1.5e-9) * 1e9, force * 1e3)

    # an AFM sphere on a soft layer on glass, with adhesion: unloading down to pull-off, noise of the deflection
    soft = mdr.Coated(RUBBER, 2e-6, mdr.Elastic(70e9, 0.23), "exact")
    radius = np.geomspace(0.3e-6, 1.2e-6, 2000)
    bare = mdr.Contact(mdr.Paraboloid(5e-6), soft).at_radius(radius)
    # energy balance: the edge opening is sqrt(4 pi a gamma/k'(a))
    opening = np.sqrt(4.0 * np.pi * radius * 0.05 / np.gradient(np.asarray(bare.stiffness), radius))
    d, f = np.asarray(bare.depth) - opening, np.asarray(bare.force) - np.asarray(bare.stiffness) * opening
    start = int(np.argmin(d))
    depth = np.linspace(d[start] + 3e-9, d[-1], 150)
    force = np.interp(depth, d[start:], f[start:]) + 0.3e-9 * random.standard_normal(depth.size)
    write("afm_on_rubber.csv", "indentation (nm),force (nN)", depth[::-1] * 1e9, force[::-1] * 1e9)

    # dynamic nanoindentation of the oxide: an elastic-plastic contact with h_c = h - sigma P/S and a hardness of 9 GPa
    film = mdr.Coated(OXIDE, 500e-9, SILICON, "exact")
    contact_depth = np.linspace(15e-9, 250e-9, 80)
    a = contact_depth / np.tan(mdr.Berkovich().inclination)
    pair = mdr.Pair(film, DIAMOND)
    load = 9e9 * np.pi * a**2
    stiffness = 2.0 * a * np.asarray(pair.modulus(a))
    h = contact_depth + sink_in(pair, a) * load / stiffness
    noisy = stiffness * (1.0 + 0.01 * random.standard_normal(a.size))
    write("csm_on_oxide.csv", "h_nm,P_mN,S_N_per_m", h * 1e9, load * 1e3, noisy)

    # the modulus as instruments export it, against a/h
    ratio = np.geomspace(0.05, 3.0, 40)
    modulus = np.asarray(film.modulus(ratio * 500e-9)) * (1.0 + 0.02 * random.standard_normal(ratio.size))
    write("modulus_of_oxide.csv", "a/h,E_eff [GPa]", ratio, modulus / 1e9)

    # stiffness against radius of flat punches on a soft layer
    a = np.linspace(0.5e-6, 8e-6, 30)
    stiffness = np.asarray(soft.stiffness(a)) * (1.0 + 0.02 * random.standard_normal(a.size))
    write("punches_on_rubber.csv", "contact radius [um],stiffness [N/m]", a * 1e6, stiffness)

    # the record of one indent into the oxide: loading, hold, unloading to 10 %, hold, unloading; with thermal drift of 0.04 nm/s
    p_max, m = 8e-3, 1.35
    a = np.sqrt(p_max / (np.pi * 9e9))
    stiffness = 2.0 * a * float(pair.modulus(a))
    contact_depth = a / np.sqrt(24.5 / np.pi)
    deepest = contact_depth + float(sink_in(pair, a)) * p_max / stiffness
    final = deepest - m * p_max / stiffness
    loads = [np.linspace(0.0, 1.0, 100), np.ones(40), np.linspace(1.0, 0.1, 120), np.full(60, 0.1), np.linspace(0.1, 0.0, 15)]
    depths = [(deepest - 1.5e-9) * np.sqrt(loads[0]), deepest - 1.5e-9 * np.exp(-np.linspace(0.0, 5.0, 40))]
    depths += [final + (deepest - final) * part ** (1.0 / m) for part in loads[2:]]
    force, depth = p_max * np.concatenate(loads), np.concatenate(depths)
    time = 0.25 * np.arange(force.size)
    depth = depth + 0.04e-9 * time + 0.05e-9 * random.standard_normal(force.size)
    force = force + 1.5e-6 * random.standard_normal(force.size)
    write("indent_on_oxide.txt", "Time (s)\tDepth (nm)\tLoad (mN)", time, depth * 1e9, force * 1e3)

    # what an AFM records on the soft layer: height of the piezo and voltage of the photodiode, approach and retract, no adhesion
    depth = np.linspace(-400e-9, 300e-9, 250)
    force = np.zeros_like(depth)
    force[depth > 0.0] = np.asarray(mdr.Contact(mdr.Paraboloid(5e-6), soft).at_depth(depth[depth > 0.0]).force)
    depth, force = (np.concatenate([v, v[::-1]]) for v in (depth, force))
    deflection = (force + 4e-9 + 6e-3 * depth + 1e-9 * random.standard_normal(depth.size)) / 30.0
    write("raw_afm_on_rubber.txt", "Height (um)\tDeflection (V)", 5.0 - 1e6 * (depth + deflection), deflection / 50e-9)

    # CSM of fused silica, E = 72 GPa, with a blunt tip A = 24.5 h_c^2 + 1200 nm h_c and a frame of 0.1 nm/mN, for its calibration
    contact_depth = np.geomspace(15e-9, 300e-9, 60)
    a = np.sqrt((24.5 * contact_depth**2 + 1200e-9 * contact_depth) / np.pi)
    stiffness = 2.0 * a / (1.0 / OXIDE.contact_modulus + 1.0 / DIAMOND.contact_modulus)
    load = 9e9 * np.pi * a**2
    h = contact_depth + (0.75 / stiffness + 1e-7) * load
    noisy = 1.0 / (1.0 / stiffness + 1e-7) * (1.0 + 0.005 * random.standard_normal(a.size))
    write("csm_on_silica.csv", "h_nm,P_mN,S_N_per_m", h * 1e9, load * 1e3, noisy)

    # an AFM sphere on a gel layer on glass: approach, hold, retract, with noise of height and deflection
    gel = mdr.Coated(mdr.PowerLawRheology(400.0, 1.0, 0.18, 0.5), 4e-6, mdr.RIGID)
    time = np.linspace(0.0, 3.0, 600)
    depth = np.interp(time, [0.0, 0.8, 2.2, 3.0], [-0.3e-6, 0.7e-6, 0.7e-6, -0.3e-6])
    force = mdr.Contact(mdr.Paraboloid(5e-6), gel).history(time, depth=depth).force + 10e-12 * random.standard_normal(time.size)
    depth = depth + 0.35e-6 + 0.2e-9 * random.standard_normal(time.size)
    write("gel_in_time.csv", "time [s],indentation [nm],force [nN]", time, depth * 1e9, force * 1e9)

    # a flat punch on a hydrogel under water: a fast ramp and a long hold, while the water leaves
    punch = mdr.Contact(mdr.FlatPunch(1e-3), mdr.Homogeneous(mdr.poroelastic.Poroelastic(28e3, 0.28, 3e-8)))
    time = np.append(np.linspace(0.0, 0.5, 11), np.geomspace(0.6, 1500.0, 189))
    depth = np.minimum(time / 0.5, 1.0) * 50e-6
    force = mdr.poroelastic.history(punch, time, depth=depth, drainage="indenter").force + 20e-6 * random.standard_normal(time.size)
    write("punch_on_hydrogel.csv", "time [s],depth [um],force [mN]", time, depth * 1e6, force * 1e3)


if __name__ == "__main__":
    main()
