#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The documentation as HTML: the guide in this folder and the description of the Fortran modules. docs/build.sh [FOLDER]
# FOLDER is build/docs by default. Needs what quickstart.sh needs; FORD comes into .venv. Status 0 only without warnings.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
log_dir=build/logs
source tools/messages.sh
source tools/system_packages.sh
source tools/python_environment.sh

install_python_package docs
.venv/bin/python docs/site/build.py "${1:-build/docs}"
