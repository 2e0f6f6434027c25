#!/bin/sh
# DXF files read by ezdxf: no audit errors, units, layers, and where their curves are.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

points() { "${LOFT:?}" run "cards/$1.crd" --format csv > "$work/$1.csv" 2> "$work/trouble"; }

# R12, in the units of the decks: inches, feet, millimetres.
for name in nose fuselage ellipsoid sphere cone; do
    points $name
    case $(millimetres cards/$name.crd) in
        1) units=4 ;;
        304.8) units=2 ;;
        *) units=1 ;;
    esac
    exported $name.dxf cards/$name.crd
    judge $name dxf.py "$work/$name.dxf" --csv "$work/$name.csv" --units $units \
        --within "$(sed -n 's/^TOLERANCE *//p' "$work/receipt")"
done

# Splines, space, other units, other tolerances.
exported splines.dxf cards/nose.crd --dxf-splines
judge 'the nose as splines' dxf.py "$work/splines.dxf" --csv "$work/nose.csv" --within 0.001 \
    --version AC1015
# Of its 12 lines two are angles.
exported space.dxf cards/fuselage.crd --3d
judge 'the fuselage in space' dxf.py "$work/space.dxf" --csv "$work/fuselage.csv" --within 0.001 \
    --space --lines 10
exported mm.dxf cards/nose.crd --units mm --tolerance 0.0001
judge 'the nose in mm, finer' dxf.py "$work/mm.dxf" --csv "$work/nose.csv" --factor 25.4 --units 4 \
    --within 0.00254
exported one.dxf cards/nose.crd --cut 1
judge 'one cut' dxf.py "$work/one.dxf" --csv "$work/nose.csv" --within 0.001 --cuts 1
finish
