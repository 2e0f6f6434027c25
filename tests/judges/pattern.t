#!/bin/sh
# Patterns as printed: pages rendered by poppler and librsvg, measured with a ruler of pixels.
cd "${ROOT:?}" || exit 1
. tests/support/judge.sh

for tool in pdftoppm pdftotext rsvg-convert; do
    command -v $tool > /dev/null && continue
    echo "1..0 # SKIP patterns are not measured: there is no $tool (poppler-utils, librsvg2-bin)"
    exit 0
done

# An ellipsoid of 40 by 24 by 20 inches; its greatest station is an ellipse of half axes 12 and 10.
cat > "$work/egg.crd" <<'CARDS'
TITLE   EGG
CLOSE
LINE    UCL     SIDE
4.      6.      999.999 12.     14.     24.     16.     0.
24.     16.     0.      40.     12.     44.     6.      999.999
LINE    LCL     SIDE
4.      6.      999.999 12.     -2.     24.     -4.     0.
24.     -4.     0.      40.     0.      44.     6.      999.999
LINE    MHB     SIDE    6.
LINE    MHB     PLAN
4.      0.      999.999 12.     9.6     24.     12.     0.
24.     12.     0.      40.     7.2     44.     0.      999.999
LINE    USH     SIDE
4.      6.      999.999 12.     12.4    24.     14.     0.
24.     14.     0.      40.     10.8    44.     6.      999.999
LINE    USH     PLAN
4.      0.      999.999 12.     5.76    24.     7.2     0.
24.     7.2     0.      40.     4.32    44.     0.      999.999
LINE    LSH     SIDE
4.      6.      999.999 12.     -.4     24.     -2.     0.
24.     -2.     0.      40.     1.2     44.     6.      999.999
LINE    LSH     PLAN    USH
SECTION UPPER   UCL     USH     MHB     0.      999.999
SECTION LOWER   LCL     LSH     MHB     0.      999.999
STATION 24.
END
CARDS
exported egg.pdf "$work/egg.crd"
judge 'an egg as PDF' pattern.py "$work/egg.pdf" --half-axes 12 10
exported egg.svg "$work/egg.crd"
judge 'an egg as SVG' pattern.py "$work/egg.svg" --half-axes 12 10
exported roll.pdf "$work/egg.crd" --paper roll 30
judge 'an egg on a roll' pattern.py "$work/roll.pdf" --half-axes 12 10
exported a4.pdf "$work/egg.crd" --paper a4
judge 'an egg on A4' pattern.py "$work/a4.pdf" --half-axes 12 10 --tiles
exported tabloid.pdf "$work/egg.crd" --paper tabloid --overlap 1
judge 'an egg on tabloid' pattern.py "$work/tabloid.pdf" --half-axes 12 10 --tiles
exported mm.pdf "$work/egg.crd" --units mm
judge 'an egg in mm' pattern.py "$work/mm.pdf" --half-axes 12 10
finish
