#!/bin/sh
# Patches as OpenCASCADE reads them: each is what Coons' formulas make of its edges, and the points
# of its cuts lie on it.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

for blend in twist flat linear; do
    deck=$work/$blend.crd
    sed "/^PATCH/s/MHB\$/MHB,$blend/; /^PATCH/s/SILL,,,/SILL,$blend,,/" cards/patch.crd > "$deck"
    "${LOFT:?}" run --format csv "$deck" > "$work/$blend.csv" 2> "$work/trouble"
    exported $blend.step "$deck"
    judge "nose cap and windshield, $blend" coons.py "$work/$blend.step" CAP SHIELD \
        --points "$work/$blend.csv" --unit 25.4 --within 1e-7 --blend $blend
done
finish
