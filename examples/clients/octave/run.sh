#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles the client into a folder and runs it: run.sh FOLDER; pkg-config finds the library.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
mkdir -p "$1"
cp law_of_ball.c law_states.c law.m "$1"
cd "$1"
read -ra flags <<< "$(pkg-config --cflags --libs mdrcontact) -Wl,-rpath,$(pkg-config --variable=libdir mdrcontact)"
for name in law_of_ball law_states; do
    mkoctfile --mex "$name.c" "${flags[@]}"
done
octave-cli --no-init-file --quiet law.m
