#!/bin/sh
# The deck a user will copy, cards/fuselage.crd: no diagnostics, the same body in columns and with
# commas, joints as meant, sections that go all the way round.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT

for name in fuselage fuselage-free; do
    "${LOFT:?}" check "cards/$name.crd" > "$work/said" 2>&1
    [ $? = 0 ] && [ ! -s "$work/said" ]
    ok $? "check has nothing to say of $name.crd" "$(cat "$work/said")"
    "$LOFT" run --format csv "cards/$name.crd" > "$work/$name.csv" 2> "$work/said"
    [ $? = 0 ] && [ ! -s "$work/said" ]
    ok $? "$name.crd runs without a diagnostic, all clearances kept" "$(cat "$work/said")"
done
! grep -v '^\*' cards/fuselage.crd | grep -q ,
ok $? 'fuselage.crd goes by columns'
! grep -v '^\*' cards/fuselage-free.crd | grep -v '^CLOSE$\|^END$' | grep -vq ,
ok $? 'fuselage-free.crd goes by commas'
cmp -s "$work/fuselage.csv" "$work/fuselage-free.csv"
ok $? 'both forms give the same CSV' "$(diff "$work/fuselage.csv" "$work/fuselage-free.csv" | head -n 4)"

"$LOFT" run cards/fuselage.crd > "$work/list" 2> "$work/said"
sed -n '/^CONTINUITY LEDGER/,/^HEIGHTS/p' "$work/list" > "$work/ledger"
[ "$(grep -c 'A KNUCKLE$' "$work/ledger")" = 2 ]
ok $? 'the base of the windshield is a knuckle, on centre line and shoulder' "$(grep KNUCKLE "$work/ledger")"
[ "$(grep -c 'SLOPE AND CURVATURE GO ON$' "$work/ledger")" = 14 ]
ok $? 'at the other fourteen joints slope and curvature go on' "$(cat "$work/ledger")"
[ "$(grep -c '^VOLUME  *303433\.65301[0-9]  ' "$work/list")" = 1 ]
ok $? 'the volume is that of Gauss quadrature of the sections, worked apart from LOFT' "$(grep '^VOLUME' "$work/list")"
! grep -q 'NO AREA' "$work/list"
ok $? 'every section closes round the body'

# At a station the sections follow each other without a gap: where one ends the next begins.
awk -F, 'NR == 1 { next }
    $2 == "station" && $1 == cut && $3 != section { at[$1 ":" last]++; at[$1 ":" $5 "," $6]++ }
    { cut = $1; section = $3; last = $5 "," $6 }
    END { for (p in at) { split(p, part, ":"); split(part[2], q, ",")
        if (at[p] < 2 && q[1] != 0) print "cut " part[1] ": an end alone at BL " q[1] ", WL " q[2] } }' \
    "$work/fuselage.csv" > "$work/alone"
[ ! -s "$work/alone" ]
ok $? 'sections of a frame meet figure for figure' "$(cat "$work/alone")"
finish
