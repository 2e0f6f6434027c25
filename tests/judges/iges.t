#!/bin/sh
# IGES files read card by card and by OpenCASCADE: entities, weights, conics against the splines
# they stand for, points of the program's tables on curves and skin, skins sewn without a gap.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

# Points of the cuts and of the skin of a deck: points NAME
points() { "${LOFT:?}" run "cards/$1.crd" --format csv > "$work/$1.csv" 2> "$work/trouble"; }

# A deck with splines and with conics, which must be the same curves: both NAME OPTIONS...
both() {
    which=$1
    shift
    exported "$which.igs" "cards/$which.crd" "$@"
    exported "$which-conics.iges" "cards/$which.crd" --iges-conics "$@"
}
same() {
    judge "$1 with conics" iges.py "$work/$1-conics.iges" --same "$work/$1.igs" --unit "$2"
}

points nose
both nose
judge 'the nose' iges.py "$work/nose.igs" --count 126=22 --count 128=2 --csv "$work/nose.csv" \
    --skin "$work/nose.csv" --within 0.001 --free 4
same nose 25.4

points fuselage
both fuselage
judge 'the fuselage' iges.py "$work/fuselage.igs" --csv "$work/fuselage.csv" \
    --skin "$work/fuselage.csv" --within 0.001 --count 144=2 --free 0
same fuselage 25.4
exported fine.igs cards/fuselage.crd --tolerance 1e-6
judge 'the fuselage to a millionth' iges.py "$work/fine.igs" --csv "$work/fuselage.csv" \
    --skin "$work/fuselage.csv" --within 1e-6 --free 0

# The volume of cards/ellipsoid.crd, half axes 100, 60 and 50 inches: 4/3 pi a b c, cubic mm.
volume=$(awk 'BEGIN { print 4/3*atan2(0, -1)*2540*1524*1270 }' OFMT=%.15g)
both ellipsoid --units mm
judge 'an ellipsoid in mm' iges.py "$work/ellipsoid.igs" --unit 1 --free 0 --volume "$volume"
same ellipsoid 1
for body in sphere round-nose paraboloid; do
    both $body --units mm
    judge "$body in mm" iges.py "$work/$body.igs" --unit 1 --free 0
    same $body 1
done
for card in sae700202 closed-forms; do
    both $card --units ft
    judge "$card in feet" iges.py "$work/$card.igs" --unit 304.8
    same $card 304.8
done
finish
