# SPDX-License-Identifier: GPL-3.0-or-later
# Saying what is going on: sourced by quickstart.sh, runtests.sh and check_packages.sh.
# shellcheck shell=bash

say() { printf '\n== %s\n' "$*"; }
note() { printf '   %s\n' "$*"; }
give_up() {
    printf '\n** %s\n' "$@" >&2
    exit 1
}

# with_progress LOG COMMAND...: runs a long command with its output in LOG, shows every few seconds where it is,
# and its last lines if it fails.
with_progress() {
    local log=$1 status=0 started=$SECONDS shown=$SECONDS
    shift
    mkdir -p "$(dirname "$log")"
    "$@" > "$log" 2>&1 &
    local job=$!
    while kill -0 "$job" 2> /dev/null; do
        sleep 0.2
        if ((SECONDS - shown >= 4)); then
            shown=$SECONDS
            note "$((SECONDS - started)) s: $(tail -n 1 "$log" | tr -d '\r' | cut -c 1-110)"
        fi
    done
    wait "$job" || status=$?
    if ((status != 0)); then
        tail -n 40 "$log" >&2
        printf '** failed with status %s; all of its output is in %s\n' "$status" "$log" >&2
    fi
    return "$status"
}
