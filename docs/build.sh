#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The documentation as HTML in build/docs: the guide in this folder by MkDocs, the Fortran modules by FORD. docs/build.sh
# Needs what quickstart.sh needs; the tools come into .venv. Status 0 only without warnings.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
log_dir=build/logs
source tools/messages.sh
source tools/system_packages.sh
source tools/python_environment.sh

install_python_package test
.venv/bin/python docs/make_tables.py --check cli.md problem-files.md
NO_MKDOCS_2_WARNING=true .venv/bin/python -m mkdocs build --strict --clean
.venv/bin/python -W ignore -m ford ford.md 2>&1 | tee "$log_dir/ford.log"
if grep -E "Warning:|Error|Traceback" "$log_dir/ford.log"; then
    give_up "FORD has warnings."
fi
.venv/bin/python docs/make_local.py build/docs/fortran
note "build/docs/index.html; with its search:  .venv/bin/python -m http.server --directory build/docs"
