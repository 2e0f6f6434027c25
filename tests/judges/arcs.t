#!/bin/sh
# Circular arcs in NC programs and DXF files, read back and compared with the points of the cuts: of
# ARCS cards, of --arcs, in inches and millimetres, of one section and of whole frames.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

# Cuts of a deck as points: points DECK
points() { "$LOFT" run --format csv "$1" -o "$work/cuts.csv" 2> "$work/trouble"; }

# --- the deck with ARCS cards: the cuts of a sheet that is a cubic and a wave ---------------------
# Points so close that their chords are within .0001 of the curves.
sed 's/  \.5  /  .01 /' cards/arcs.crd > "$work/fine.crd"
points "$work/fine.crd"
exported arcs.nc cards/arcs.crd
judge 'arcs.nc' nc.py "$work/arcs.nc" --csv "$work/cuts.csv" --within .01 --back .0101 --arcs
exported arcs.dxf cards/arcs.crd
judge 'arcs.dxf' dxf.py "$work/arcs.dxf" --csv "$work/cuts.csv" --within .01 --back .0101 --arcs
exported arcs-2000.dxf cards/arcs.crd --dxf-splines
judge 'arcs.dxf of R2000' dxf.py "$work/arcs-2000.dxf" --csv "$work/cuts.csv" --within .01 \
    --back .0101 --arcs --version AC1015
exported arcs-mm.nc cards/arcs.crd --units mm --arcs --tolerance .0005
judge 'arcs.nc in millimetres' nc.py "$work/arcs-mm.nc" --csv "$work/cuts.csv" --factor 25.4 \
    --units mm --within .0127 --back .016 --arcs

# --- other decks, every cut -----------------------------------------------------------------------
points cards/nose.crd
exported nose.nc cards/nose.crd --arcs
judge 'nose.nc --arcs' nc.py "$work/nose.nc" --csv "$work/cuts.csv" --within .001 --back .2 --arcs
exported nose.dxf cards/nose.crd --arcs --tolerance .0002
judge 'nose.dxf --arcs' dxf.py "$work/nose.dxf" --csv "$work/cuts.csv" --within .0002 --back .2 --arcs
points cards/sphere.crd
exported sphere.nc cards/sphere.crd --arcs --units mm
judge 'sphere.nc --arcs' nc.py "$work/sphere.nc" --csv "$work/cuts.csv" --factor 304.8 --units mm \
    --within .0244 --arcs
finish
