#!/bin/sh
# STEP files read by OpenCASCADE: sound solids and shells without a gap, areas and volumes as the
# listing has them, points of the exact skin and cuts by planes where they should be.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

# A body deck as STEP, its areas and volume: measured NAME OPTIONS OF THE JUDGE...
measured() {
    name=$1 unit=$(millimetres "cards/$1.crd")
    shift
    exported "$name.step" "cards/$name.crd"
    "${LOFT:?}" run "cards/$name.crd" > "$work/listing" 2> "$work/trouble"
    area=$(measure 'WETTED AREA' "$work/listing") volume=$(measure VOLUME "$work/listing")
    if [ -n "$volume" ]; then
        [ "$(grep -c MANIFOLD_SOLID_BREP "$work/$name.step")" = 1 ]
        ok $? "$name: what has a volume is a solid"
        judge "$name" step.py "$work/$name.step" --unit "$unit" --solids 1 --shells 1 --free 0 \
            --skin "$area" --volume "$volume" "$@"
    else
        judge "$name" step.py "$work/$name.step" --unit "$unit" --solids 0 --skin "$area" "$@"
    fi
}

points() { "${LOFT:?}" run "cards/$1.crd" --format csv > "$work/$1.csv" 2> "$work/trouble"; }

points nose
measured nose --shells 1 --points "$work/nose.csv" --cuts "$work/nose.csv" \
    --sections "$work/nose.csv" --within 0.001
points fuselage
measured fuselage --points "$work/fuselage.csv" --sample 500 --within 0.001
for deck in ellipsoid sphere paraboloid round-nose; do
    points $deck
    measured $deck --points "$work/$deck.csv" --sample 50 --within 0.001
done
measured cone
measured batten

# Finer, in another unit, without caps.
exported fine.step cards/nose.crd --tolerance 1e-6 --units mm
awk -F, -v OFS=, 'NR > 1 { for (i = 4; i <= 6; i++) $i *= 25.4 } 1' OFMT='%.17g' CONVFMT='%.17g' \
    "$work/nose.csv" > "$work/mm.csv"
judge 'the nose to a millionth, in mm' step.py "$work/fine.step" --unit 1 --points "$work/mm.csv" \
    --within 2.54e-5
exported open.stp cards/fuselage.crd --open --cut 1
judge 'the fuselage open' step.py "$work/open.stp" --unit 25.4 --solids 0

# Curves alone: of a deck of 1970.
exported cards.step cards/sae700202.crd
judge 'the deck of 1970' step.py "$work/cards.step" --unit 25.4 --solids 0 --faces 0 --curves 11
finish
