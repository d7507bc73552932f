#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles the client into a folder and runs it: run.sh FOLDER; pkg-config finds the library.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
mkdir -p "$1"
cp law.c law.R "$1"
cd "$1"
PKG_CPPFLAGS=$(pkg-config --cflags mdrcontact) PKG_LIBS="$(pkg-config --libs mdrcontact) -Wl,-rpath,$(pkg-config --variable=libdir mdrcontact)"
export PKG_CPPFLAGS PKG_LIBS
R CMD SHLIB law.c > build.log
Rscript law.R
