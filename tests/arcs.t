#!/bin/sh
# ARCS cards and --arcs: tables of the listing, G2 and G3, bulges, faults, what the points of the
# cuts know of them (nothing).
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
loft=${LOFT:?} cards=$PWD/cards
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# Counts the check that a text is as expected: TEXT EXPECTED NAME
same() {
    [ "$1" = "$2" ]
    ok $? "$3" "$1"
}

# --- the listing ----------------------------------------------------------------------------------
"$loft" run "$cards/arcs.crd" -o arcs.lst
# The line below the head of the arcs of a cut: outline NUMBER
outline() { sed -n "/^ARCS OF CUT $1,/{n;p;}" arcs.lst; }
same "$(outline 1)" 'OUTLINE 1, OPEN: 28 ARCS, 29 POINTS, 14 OF THEM SECONDARY (S)' \
    'the cubic has the 29 points of the paper'
same "$(outline 2)" 'OUTLINE 1, OPEN: 1 ARC, 2 POINTS' 'a straight frame is one line'
same "$(outline 3)" 'OUTLINE 1, OPEN: 36 ARCS, 37 POINTS, 18 OF THEM SECONDARY (S)' \
    'the wave within .01: 19 initial points, as between .0075 and .01'
same "$(outline 5)" '' 'ARCS 0. ends it'
same "$(sed -n '/^ARCS OF CUT 1,/,/^LARGEST/p' arcs.lst | grep -c '^ *[0-9]* S ')" 14 \
    'secondary points are marked'
grep -q '^LARGEST DEVIATION 3.7E-03, OF ARC [0-9]* AT U ' arcs.lst
ok $? 'the largest deviation has its place'
sed '/^ARCS/d' "$cards/arcs.crd" > plain.crd
"$loft" run --format csv "$cards/arcs.crd" -o arcs.csv
"$loft" run --format csv plain.crd -o plain.csv
cmp -s arcs.csv plain.csv
ok $? 'the points of the cuts are as without them'

# --- faults ---------------------------------------------------------------------------------------
sed 's/^ARCS    .005/ARCS    -.005/' "$cards/arcs.crd" > bad.crd
"$loft" check bad.crd 2> err
same "$? $(head -n 1 err)" '1 bad.crd:27:9-16: error: the tolerance is negative; 0. ends the arcs' \
    'a negative tolerance is a fault of its card'
sed 's/^ARCS    .005/ARCS    1.E-18/' "$cards/arcs.crd" > bad.crd
"$loft" check bad.crd 2> err
[ $? = 1 ] && grep -q '^bad.crd:28:1-8: error: ' err
ok $? 'one that can not be kept is a fault of the cut' "$(cat err)"
"$loft" run bad.crd -o bad.lst 2> /dev/null
same "$? $(grep -c '^CUT ' bad.lst) $(grep -c '^ARCS OF' bad.lst)" '1 5 3' \
    'its points are printed all the same, and the arcs of other cuts'

# --- NC and DXF -----------------------------------------------------------------------------------
# How many lines of a file match: has PATTERN FILE
has() { grep -c "$1" "$2"; }
"$loft" export "$cards/arcs.crd" -o arcs.nc > receipt
same "$(has '^G[23] X.* Y.* I.* J' arcs.nc) $(has '^(CIRCULAR ARCS WITHIN' arcs.nc)" '92 4' \
    'the cuts under ARCS are arcs in NC'
grep -q '^TOLERANCE  0.01$' receipt
ok $? 'the tolerance of the receipt is the largest of all' "$(cat receipt)"
"$loft" export "$cards/arcs.crd" -o all.nc --arcs > receipt
grep -q '^TOLERANCE  0.001$' receipt && ! grep -q 'PATH  ' receipt
ok $? '--arcs is for all cuts, within --tolerance' "$(cat receipt)"
"$loft" export plain.crd -o plain.nc > receipt
same "$(has '^G[23] ' plain.nc)" 0 'without either there is none'
"$loft" export "$cards/arcs.crd" -o arcs.dxf > receipt
# Bulges of the corners of polylines.
bulges() { sed -n '/^VERTEX$/,/^SEQEND$/p' "$1" | grep -c '^ 42$'; }
same "$(bulges arcs.dxf)" 94 'bulges in R12'
"$loft" export "$cards/arcs.crd" -o new.dxf --dxf-splines > receipt
same "$(has '^LWPOLYLINE$' new.dxf) $(has '^SPLINE$' new.dxf)" '4 1' \
    'in R2000 LWPOLYLINE, and SPLINE where no arcs are asked'
"$loft" export "$cards/arcs.crd" -o space.dxf --3d > receipt
same "$(bulges space.dxf) $(has '^TOLERANCE  0.001$' receipt)" '0 1' 'in space there are none'
"$loft" export "$cards/sae700202.crd" -o old.nc --arcs > receipt
[ "$(has '^G[23] ' old.nc)" -gt 100 ]
ok $? 'a 1970 deck has arcs, too'
for file in a.svg a.step; do
    "$loft" export "$cards/arcs.crd" -o $file --arcs 2> err
    [ $? = 2 ] && grep -q 'does not go with' err && [ ! -e $file ]
    ok $? "--arcs and $file do not go together" "$(cat err)"
done
finish
