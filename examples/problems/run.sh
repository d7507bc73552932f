#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every problem beside this file, each by the commands that its sections are for: run.sh MDRCONTACT OUTPUT_FOLDER
set -euo pipefail
mdrcontact=$1
output=$2

# has SECTION PROBLEM: whether the problem file has the section.
has() {
    grep -q "^\[$1\]" "$2"
}

for problem in "$(dirname "${BASH_SOURCE[0]}")"/*.toml; do
    name=$output/$(basename "$problem" .toml)
    echo "$problem"
    if has history "$problem"; then
        "$mdrcontact" history "$problem" --csv "$name.csv" --plot "$name.png" --overwrite
        continue # a viscoelastic body has no force without its past
    fi
    if has imprint "$problem"; then
        "$mdrcontact" imprint "$problem" --csv "$name.csv" --plot "$name.png" --overwrite
        continue # a plastic contact is not loaded elastically
    fi
    "$mdrcontact" curve "$problem" --csv "$name.csv" --plot "$name.png" --overwrite
    "$mdrcontact" compare "$problem" --plot "$name-models.png" --overwrite
    if has adhesion "$problem"; then
        "$mdrcontact" adhesion "$problem" --csv "$name-loop.csv" --plot "$name-loop.png" --overwrite
    fi
    if has strength "$problem"; then
        "$mdrcontact" stress "$problem" --csv "$name-stress.csv" --plot "$name-stress.png" --overwrite
    fi
    if has friction "$problem"; then
        "$mdrcontact" friction "$problem" --csv "$name-friction.csv" --plot "$name-friction.png" --overwrite
    fi
    if has wear "$problem"; then
        "$mdrcontact" wear "$problem" --csv "$name-wear.csv" --plot "$name-wear.png" --overwrite
    fi
    if has conduction "$problem"; then
        "$mdrcontact" conduction "$problem" --csv "$name-conduction.csv" --plot "$name-conduction.png" --overwrite
    fi
done
