#!/bin/sh
# Faired lines and outlines as listed, against dense systems solved by numpy; a duct through such
# outlines against splines of scipy, and as OpenCASCADE reads it.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

for deck in inlet faired; do
    "${LOFT:?}" run "cards/$deck.crd" > "$work/$deck.lst" 2> "$work/trouble"
    ok $? "cards/$deck.crd is run" "$(cat "$work/trouble")"
    judge "$deck" fairing.py "cards/$deck.crd" "$work/$deck.lst"
done

deck=cards/duct.crd
"${LOFT:?}" run $deck > "$work/duct.lst" 2> "$work/trouble"
ok $? "$deck is run" "$(cat "$work/trouble")"
"$LOFT" run --format csv $deck > "$work/duct.csv"
exported duct.step $deck
judge duct duct.py $deck "$work/duct.lst" "$work/duct.csv" "$work/duct.step"
finish
