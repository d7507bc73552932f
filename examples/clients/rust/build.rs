// SPDX-License-Identifier: GPL-3.0-or-later
// Declarations from the installed header, and the folder of the library, both found by pkg-config (PKG_CONFIG_PATH).
use std::{env, fs, path::Path, process::Command};

fn output(program: &str, arguments: &[&str]) -> String {
    let done = Command::new(program).args(arguments).output().unwrap_or_else(|error| panic!("{program}: {error}"));
    assert!(done.status.success(), "{program} {arguments:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap()
}

fn main() {
    let place = |name: &str| output("pkg-config", &[&format!("--variable={name}"), "mdrcontact"]).trim().to_string();
    let header = format!("{}/mdrcontact.h", place("includedir"));
    let file = Path::new(&env::var("OUT_DIR").unwrap()).join("mdrcontact.rs");
    fs::write(file, output("python3", &["declare.py", &header])).unwrap();
    println!("cargo:rustc-link-search=native={}", place("libdir"));
    println!("cargo:rustc-link-lib=dylib=mdrcontact");
    println!("cargo:rustc-link-arg=-Wl,-rpath,{}", place("libdir"));
    println!("cargo:rerun-if-changed=declare.py");
    println!("cargo:rerun-if-changed={header}");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
}
