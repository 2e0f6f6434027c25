#!/bin/sh
# Lines that are no conics, against SciPy and NumPy: splines, Bezier and C-Bezier curves, spirals, and
# a line of high degree in a DXF file.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

for name in batten c-bezier blend; do
    "${LOFT:?}" run "cards/$name.crd" --format csv > "$work/$name.csv" 2> "$work/trouble"
    judge "lines of $name" curves.py $name cards/$name.crd --csv "$work/$name.csv"
done

cat > "$work/high.crd" << 'DECK'
TITLE   A LINE OF DEGREE 13
UNITS   INCHES
LINE    UCL     SIDE    BEZIER
0.      10.
8.      24.
16.     2.
24.     31.
32.     -4.
40.     36.
48.     -6.
56.     38.
64.     -5.
72.     33.
80.     0.
88.     26.
96.     6.
104.    14.
LINE    SHL     SIDE    8.
LINE    SHL     PLAN    5.
LINE    MHB     SIDE    0.
LINE    MHB     PLAN    7.
SECTION UP      UCL     SHL     MHB     0.      999.999
BUTTOCK 0.      0.      104.    4.
END
DECK
exported high.dxf "$work/high.crd" --dxf-splines --3d
judge 'a line of degree 13' curves.py lowering "$work/high.crd" --dxf "$work/high.dxf" --within 0.001
finish
