#!/bin/sh
# Faired lines and outlines as listed, against dense systems solved by numpy.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

for deck in inlet faired; do
    "${LOFT:?}" run "cards/$deck.crd" > "$work/$deck.lst" 2> "$work/trouble"
    ok $? "cards/$deck.crd is run" "$(cat "$work/trouble")"
    judge "$deck" fairing.py "cards/$deck.crd" "$work/$deck.lst"
done
finish
