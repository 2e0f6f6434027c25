#!/bin/sh
# NC programs run by an interpreter of RS274/NGC: where the tool went, and that no line surprises a
# machine.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

points() { "${LOFT:?}" run "cards/$1.crd" --format csv > "$work/$1.csv" 2> "$work/trouble"; }

for name in nose fuselage ellipsoid; do
    points $name
    exported $name.nc cards/$name.crd
    judge $name nc.py "$work/$name.nc" --csv "$work/$name.csv" --within 0.001 --depth -0.125
done
for name in cone round-nose; do
    points $name
    exported $name.ngc cards/$name.crd --depth -2 --feed 300
    judge "$name in mm" nc.py "$work/$name.ngc" --csv "$work/$name.csv" --units mm \
        --within 0.025 --depth -2
done
# Decks in feet become programs in inches: machines know no feet.
points sphere
exported sphere.nc cards/sphere.crd
judge 'the sphere, in feet, cut in inches' nc.py "$work/sphere.nc" --csv "$work/sphere.csv" \
    --factor 12 --within 0.00096
exported mm.gcode cards/nose.crd --units mm --tolerance 0.0002
judge 'the nose in mm' nc.py "$work/mm.gcode" --csv "$work/nose.csv" --factor 25.4 --units mm \
    --within 0.00508
finish
