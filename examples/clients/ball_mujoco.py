# SPDX-License-Identifier: GPL-3.0-or-later
"""MuJoCo: a steel ball bounces on a rubber mat on a steel floor; the contact force is that of a compiled law.

MuJoCo's own contacts are switched off (contype = 0). Its callback for passive forces adds the law's F(d) at each evaluation of the
dynamics, four times a step of the Runge-Kutta integrator.

Checks: the energy of motion, gravity and contact (the law's int F dd) stays at every step, over three bounces; so does the height
of the bounces; the greatest depth is that at which the contact has taken up the energy of the fall.
SI units. Rubber mat E = 2 MPa, nu = 0.45, 2 mm thick; steel E = 210 GPa, nu = 0.3, 7850 kg/m^3 (handbook values).
"""

import time

import mujoco
import numpy as np
from scipy.optimize import brentq

import mdrcontact as mdr

RADIUS, HEIGHT, GRAVITY, STEP = 10e-3, 2e-3, 9.81, 2e-5
STEEL, RUBBER = mdr.Elastic(210e9, 0.3), mdr.Elastic(2e6, 0.45)
MODEL = f"""
<mujoco>
  <option timestep="{STEP}" integrator="RK4" gravity="0 0 {-GRAVITY}"/>
  <worldbody>
    <body pos="0 0 {RADIUS + HEIGHT}">
      <freejoint/>
      <geom type="sphere" size="{RADIUS}" density="7850" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
</mujoco>
"""


def main():
    """See the top of this file."""
    mat = mdr.Pair(mdr.Coated(RUBBER, 2e-3, STEEL), mdr.Homogeneous(STEEL))  # the ball's own deformation in series
    law = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(RADIUS), mat), largest_depth=1e-3)
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)

    def contact_force(_, data):
        data.qfrc_passive[2] += law.force(RADIUS - data.qpos[2])  # 0 above the mat

    heights, speeds = [], []
    start = time.process_time()
    mujoco.set_mjcb_passive(contact_force)
    try:
        while data.time < 0.15:
            mujoco.mj_step(model, data)
            heights.append(data.qpos[2] - RADIUS)
            speeds.append(data.qvel[2])
    finally:
        mujoco.set_mjcb_passive(None)
    cost = (time.process_time() - start) / len(heights)

    mass = model.body_mass[1]
    height, speed = np.array(heights), np.array(speeds)
    fall = mass * GRAVITY * HEIGHT
    energy = mass * (GRAVITY * height + 0.5 * speed**2) + law.energy(-height)
    drift = np.max(np.abs(energy / fall - 1))
    tops = height[1:][(speed[:-1] > 0) & (speed[1:] <= 0)]
    expected = brentq(lambda d: law.energy(d) - mass * GRAVITY * (HEIGHT + d), 1e-6, 1e-3)
    deepest = -np.min(height)
    print(f"{len(tops)} bounces up to {', '.join(f'{top * 1e3:.6f}' for top in tops)} mm from {HEIGHT * 1e3} mm")
    print(f"greatest depth {deepest * 1e6:.3f} um, by the energy of the fall {expected * 1e6:.3f} um")
    print(f"energy: largest change {drift:.1e}; {cost * 1e6:.1f} us a step")
    assert len(tops) == 3
    assert drift < 1e-6, "energy is not conserved"
    assert np.max(np.abs(tops / HEIGHT - 1)) < 1e-6, "the bounces differ in height"
    assert abs(deepest / expected - 1) < 1e-4, "the depth is not that of the energy"


if __name__ == "__main__":
    main()
