# SPDX-License-Identifier: GPL-3.0-or-later
# Saying what is going on: sourced by quickstart.sh, runtests.sh and check_packages.sh.
# shellcheck shell=bash

say() { printf '\n== %s\n' "$*"; }
note() { printf '   %s\n' "$*"; }
give_up() {
    printf '\n** %s\n' "$@" >&2
    exit 1
}

# place_in LOG: its last line, after a percentage if that counts as [n/m]
place_in() {
    local line
    line=$(tail -n 1 "$1" | tr -d '\r' | cut -c 1-100)
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] && line="$((100 * BASH_REMATCH[1] / BASH_REMATCH[2])) % $line"
    printf '%s' "$line"
}

# with_progress LOG COMMAND...: runs a long command with its output in LOG, shows where it is every few seconds, or every half minute
# while nothing new is written, and its last lines if it fails.
with_progress() {
    local log=$1 status=0 started=$SECONDS shown=$SECONDS place last=
    shift
    mkdir -p "$(dirname "$log")"
    "$@" > "$log" 2>&1 &
    local job=$!
    while kill -0 "$job" 2> /dev/null; do
        sleep 0.2
        ((SECONDS - shown >= 4)) || continue
        place=$(place_in "$log")
        [[ $place != "$last" ]] || ((SECONDS - shown >= 30)) || continue
        shown=$SECONDS last=$place
        note "$((SECONDS - started)) s: $place"
    done
    wait "$job" || status=$?
    if ((status != 0)); then
        tail -n 40 "$log" >&2
        printf '** failed with status %s; all of its output is in %s\n' "$status" "$log" >&2
    fi
    return "$status"
}
