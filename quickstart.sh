#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# From a bare Debian or Ubuntu machine to force-depth curves of real coated bodies: ./quickstart.sh
# Installs what is missing (asks for sudo if need be), makes .venv with the package, computes every problem of examples/problems.
# Run again at any time; what is up to date is left alone.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
log_dir=output/logs
source tools/messages.sh
source tools/system_packages.sh
source tools/python_environment.sh

note "This takes about 3 minutes on two cores, after the download of packages."
say "1/3 System packages"
install_system_packages
say "2/3 Python package in .venv"
install_python_package all

say "3/3 Contact of coated bodies"
.venv/bin/python examples/problems/run.py output

say "Done in $SECONDS s. Plots and tables:"
for file in output/*.png output/*.csv; do
    note "$PWD/$file"
done
say "Next"
note "source .venv/bin/activate"
note "mdrcontact curve --help                      what a problem file may hold"
note "cp examples/problems/sio2_on_si.toml mine.toml"
note "mdrcontact curve mine.toml --plot mine.png   with your own indenter and coating in mine.toml"
note "mdrcontact app                               a page in the browser: forms, figures and fits of dropped files"
note "./runtests.sh                                the tests, in Fortran, C and Python; --all: the long ones, too"
