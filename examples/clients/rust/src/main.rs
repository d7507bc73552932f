// SPDX-License-Identifier: GPL-3.0-or-later
//! Rust: steel balls of several sizes fall on a painted plate, each in a thread of its own, all with laws from one solution of the
//! contact. Checks: each ball comes back as fast as it came; its greatest depth is that at which the law's energy, int F dd, is that
//! of its fall.
//!
//! SI units. Epoxy paint E = 3 GPa, nu = 0.35, 25 um thick, on aluminium E = 70 GPa, nu = 0.33; balls 7850 kg/m^3, taken as rigid.
use std::{f64::consts::PI, ffi::CStr, ptr, thread};

/// The declarations that build.rs makes of mdrcontact.h.
#[allow(dead_code, non_camel_case_types, non_snake_case)]
mod mdr {
    include!(concat!(env!("OUT_DIR"), "/mdrcontact.rs"));
}

/// What the library says where a call fails.
fn check(status: i32) -> Result<(), String> {
    if status == mdr::MDR_SUCCESS {
        return Ok(());
    }
    Err(unsafe { CStr::from_ptr(mdr::mdr_last_error()) }.to_string_lossy().into_owned())
}

/// A layer of an isotropic material, bonded and free of stress.
fn isotropic(young: f64, nu: f64, thickness: f64) -> mdr::mdr_layer {
    let mut layer: mdr::mdr_layer = unsafe { std::mem::zeroed() };
    layer.size = std::mem::size_of::<mdr::mdr_layer>();
    (layer.E, layer.nu, layer.thickness) = (young, nu, thickness);
    layer
}

/// A compiled law, which frees itself.
struct Law(*mut mdr::mdr_law);

// A law never changes: any number of threads may use it.
unsafe impl Send for Law {}
unsafe impl Sync for Law {}

impl Drop for Law {
    fn drop(&mut self) {
        unsafe { mdr::mdr_free(self.0.cast()) };
    }
}

impl Law {
    /// Of a ball of the given radius on the painted plate.
    fn new(radius: f64, largest_depth: f64) -> Result<Law, String> {
        let mut law = Law(ptr::null_mut());
        let (mut ball, mut plate) = (ptr::null_mut(), ptr::null_mut());
        let (mut medium, mut contact) = (ptr::null_mut(), ptr::null_mut());
        let (paint, aluminium) = (isotropic(3e9, 0.35, 25e-6), isotropic(70e9, 0.33, 0.0));
        unsafe {
            let made = check(mdr::mdr_profile_paraboloid(radius, &mut ball))
                .and_then(|()| check(mdr::mdr_body_layered(1, &paint, &aluminium, ptr::null(), &mut plate)))
                .and_then(|()| check(mdr::mdr_medium_new(plate, ptr::null(), &mut medium)))
                .and_then(|()| check(mdr::mdr_contact_new(ball, medium, ptr::null(), &mut contact)))
                .and_then(|()| check(mdr::mdr_law_new(contact, largest_depth, ptr::null(), &mut law.0)));
            mdr::mdr_free(contact.cast());
            mdr::mdr_free(medium.cast());
            mdr::mdr_free(plate.cast());
            mdr::mdr_free(ball.cast());
            made.map(|()| law)
        }
    }

    /// Of a ball of another radius, without solving again.
    fn with_radius(&self, radius: f64) -> Result<Law, String> {
        let mut law = Law(ptr::null_mut());
        check(unsafe { mdr::mdr_law_with_radius(self.0, radius, &mut law.0) }).map(|()| law)
    }

    fn force(&self, depth: f64) -> Result<f64, String> {
        let mut force = 0.0;
        check(unsafe { mdr::mdr_law_force(self.0, mdr::MDR_ON_UNLOADING, depth, &mut force, ptr::null_mut()) }).map(|()| force)
    }

    fn energy(&self, depth: f64) -> Result<f64, String> {
        let mut energy = 0.0;
        let (law, none) = (self.0, ptr::null_mut());
        let (given, branch) = (mdr::MDR_DEPTH, mdr::MDR_ON_UNLOADING);
        check(unsafe { mdr::mdr_law_values(law, given, branch, 1, &depth, none, none, none, none, none, &mut energy) }).map(|()| energy)
    }
}

/// Greatest depth and speed of rebound of a mass that comes at a speed, by the leap-frog scheme.
fn impact(law: &Law, mass: f64, speed: f64, step: f64) -> Result<(f64, f64), String> {
    let (mut d, mut v, mut force, mut deepest) = (0.0, speed, 0.0, 0.0f64);
    loop {
        v -= 0.5 * step * force / mass;
        d += step * v;
        force = law.force(d)?;
        v -= 0.5 * step * force / mass;
        deepest = deepest.max(d);
        if d <= 0.0 {
            return Ok((deepest, -v));
        }
    }
}

fn main() -> Result<(), String> {
    let speed = 0.1;
    let radii = [0.25e-3, 0.5e-3, 1e-3, 2e-3];
    let law = Law::new(1e-3, 5e-6)?;
    thread::scope(|scope| {
        let balls: Vec<_> = radii
            .iter()
            .map(|&radius| {
                let law = &law;
                scope.spawn(move || -> Result<(), String> {
                    let law = law.with_radius(radius)?;
                    let mass = 4.0 / 3.0 * PI * radius * radius * radius * 7850.0;
                    let (deepest, rebound) = impact(&law, mass, speed, 2e-5 * radius)?;
                    let balance = law.energy(deepest)? / (0.5 * mass * speed * speed) - 1.0;
                    let change = rebound / speed - 1.0;
                    println!(
                        "R = {:4.2} mm   depth {:.4} um   speed changed by {:.0e}, energy at the greatest depth by {:.0e}",
                        radius * 1e3, deepest * 1e6, change, balance
                    );
                    if change.abs() < 1e-6 && balance.abs() < 1e-5 {
                        Ok(())
                    } else {
                        Err("the energy is not conserved".into())
                    }
                })
            })
            .collect();
        balls.into_iter().try_for_each(|ball| ball.join().expect("a thread ended"))
    })
}
