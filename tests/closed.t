#!/bin/sh
# The deck of conics in closed form against the equations that stand above its cards: distance of
# every row of the CSV from the curve, slope and curvature by the derivatives of the equation.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT

"${LOFT:?}" run --format csv cards/closed-forms.crd > "$work/csv" 2> "$work/faults"
ok $? 'the deck runs without an error' "$(cat "$work/faults")"
grep -c ': warning: the arc turns by more than 180 degrees' "$work/faults" | grep -qx 1
ok $? 'the arc of 286 degrees is warned of, and no other' "$(cat "$work/faults")"

# The equations of the cards as F(x, y) = 0 with their derivatives, in the order of the deck.
awk -F, -v ulp=2.220446049250313e-16 '
function abs(v) { return v < 0 ? -v : v }
function conic(a, b, c, d, e, f) {    # a xx + b xy + c yy + d x + e y + f about (x0, y0)
    F = a*X*X + b*X*Y + c*Y*Y + d*X + e*Y + f
    Fx = 2*a*X + b*Y + d; Fy = b*X + 2*c*Y + e; Fxx = 2*a; Fxy = b; Fyy = 2*c
}
NR == 1 { next }
{
    rows[$1 $2]++
    X = $3; Y = $4
    if ($1 == 6) { X = $3 + 5000; Y = $4 + 200 }
    if ($1 <= 6) conic(1, 0, 1, 0, 0, -25)
    if ($1 == 7) conic(1, 0, 4, 0, 0, -100)
    if ($1 == 8) conic(1, 0, 0, 0, -10, 0)
    if ($1 == 9) conic(0, 0, 1, -10, 0, 0)
    if ($1 == 10) conic(0, 1, 0, 0, 0, -10)
    if ($1 == 11) conic(0, 0, 0, 1, -2, 0)
    if ($1 == 12) conic(0, 0, 0, 1, 0, -3)
    steep = sqrt(Fx*Fx + Fy*Fy)
    size = abs($3) > abs($4) ? abs($3) : abs($4)
    off = abs(F)/steep/(ulp*size)
    if (off > worst) worst = off
    if ($5 == "inf") { if (abs(Fy) > 1e-9*steep) print "row " NR ": not vertical: " $0 }
    else if (abs($5*Fy + Fx) > 1e-12*steep*sqrt(1 + $5*$5)*size) print "row " NR ": slope: " $0
    bend = abs(Fxx*Fy*Fy - 2*Fxy*Fx*Fy + Fyy*Fx*Fx)/steep^3
    if (abs(bend - abs($6)) > 1e-11*bend) print "row " NR ": curvature: " $0 " not " bend
    if (last == $1 $2 && sign*$6 < 0) print "row " NR ": curvature changes its sign: " $0
    last = $1 $2; sign = $6
}
END {
    if (worst > 4) print "a row is " worst " ulp off its curve"
    print "rows:", rows["1X"], rows["1Y"], rows["2X"], rows["3X"], rows["4X"], rows["4Y"], rows["5Y"], rows["12Y"]
}' "$work/csv" > "$work/wrong"
[ "$(grep -v '^rows:' "$work/wrong")" = '' ]
ok $? 'every row is on its curve within 4 ulp, with the slope and the curvature of it' "$(cat "$work/wrong")"
grep -qx 'rows: 6 6 6 11 8 10 19 5' "$work/wrong"
ok $? 'the tables have the rows that stepping by hand gives' "$(cat "$work/wrong")"

# Figure for figure, where slope and curvature are numbers of few figures too.
for row in '1,X,-5,0,inf,-0.2' '1,X,-4,3,1.3333333333333333,-0.2' '1,X,-3,4,0.75,-0.2' \
    '1,X,0,5,0,-0.2' '2,X,-3,4,0.75,0.2' '3,X,4,3,-1.3333333333333333,-0.2' '4,X,3,-4,0.75,-0.2' \
    '6,X,-5003,-196,0.75,-0.2' '7,X,10,0,inf,-0.4' '7,Y,0,5,0,-0.05' '8,X,3,0.9,0.6,0.12610190084008002' \
    '9,Y,2.5,5,1,-0.07071067811865475' '11,X,7.5,3.75,0.5,0' '12,Y,3,-1,inf,0'; do
    grep -qxF -- "$row" "$work/csv"
    ok $? "there is the row $row"
done
[ "$(grep -c '^5,X' "$work/csv")" = 0 ]
ok $? 'a blank XI beside an ITYP makes a Y table alone'
[ "$(grep -c '^4,X,[34],' "$work/csv")" = 4 ]
ok $? 'an ordinate passed twice stands twice, steps going on beyond X3'

sed 's/^.* TURNS BY/TURNS BY/' golden/closed-forms.ieee.lst > "$work/kinds"
for kind in CIRCLE ELLIPSE PARABOLA HYPERBOLA 'STRAIGHT LINE' 'TURNS BY MORE THAN 180 DEGREES'; do
    grep -q "^$kind" "$work/kinds"
    ok $? "a conic of the deck is called $kind"
done

# Lines as C-Bezier curves that are quarters of ellipses: an ellipsoid forward of station 30.
"$LOFT" run --format csv cards/c-bezier.crd > "$work/csv" 2> "$work/faults"
ok $? 'the deck of C-Bezier lines runs without an error' "$(cat "$work/faults")"
awk -F, 'NR > 1 && $4 <= 30 {
    n++
    off = ($4 - 30)^2/900 + $5^2/400 + $6^2/100 - 1
    if (off < 0) off = -off
    if (off > worst) worst = off
} END { exit !(n > 50 && worst < 1e-14) }' "$work/csv"
ok $? 'every row forward of station 30 is on the ellipsoid'
finish
