#!/bin/sh
# The comparison with the printed book (`make book`) as a whole: its closing count.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
folder=$(dirname "${LOFT:?}")
for book in "$folder/release/tests/book/book" "$folder/tests/book/book"; do
    [ -x "$book" ] && break
done
shown=$("$book")
status=$?

[ "$status" = 0 ]
ok $? 'the comparison ends with status 0' "status $status of $book"
echo "$shown" | grep -q '^In System/360 arithmetic 84 of 84 ordinates and 5 of 5 coefficients$'
ok $? 'all ordinates and coefficients of the book come out as printed' "$(echo "$shown" | tail -n 12)"
[ "$(echo "$shown" | grep -c '^ *-*[0-9.]* .* -*[0-9]*\.[0-9]* .* -*[0-9]*$')" -ge 84 ]
ok $? 'every ordinate has its line'
echo "$shown" | grep -q '^Of the ordinates 54 agree as scanned, 20 differ in one character, 10 in more\.$'
ok $? 'the scan is as damaged as the book page says'
echo "$shown" | awk '/over all/ && !met { met = 1; if ($3 > 0 && $3 <= 0.0015) good = 1 } END { exit !good }'
ok $? 'the listing of 1970 keeps the .0015 in that the paper claims, on its cards as punched'
echo "$shown" | grep -q '^Largest distance of a printed point from that nose:  0\.00[0-3][0-9]* in$'
ok $? 'the points of table 4 are within .004 in of the nose made of table 1 alone' "$(echo "$shown" | tail -n 1)"
echo "$shown" | grep -q '^   1000000 *0.0 *10.1366 *1.2291 *1.4202 *1.1967 *1.2764 *1.1981$' &&
    echo "$shown" | grep -q '^       100 *0.0 *10.0593 *1.1702 *0.3712 *1.1924 *0.3639 *1.1927$' &&
    echo "$shown" | grep -q '^       100 *-3.0 *10.0434 *1.1802 *0.3677 *1.1800 *0.3592 *1.1800$'
ok $? 'the inlet as printed has its figures beside those of a dense solution' "$(echo "$shown" | tail -n 15)"
echo "$shown" | grep -q 'The printed 0.0773 then allows areas about 0.0221 apart;$' &&
    echo "$shown" | grep -q '^printed they are 0.0589, '
ok $? 'and why they can not be least values' "$(echo "$shown" | tail -n 5)"
! echo "$shown" | grep -q '.\{81\}'
ok $? 'no line is wider than 80 columns'

broken=$(mktemp -d) && trap 'rm -rf "$broken"' EXIT
mkdir -p "$broken/golden" "$broken/cards"
cp -r golden/book "$broken/golden" && cp cards/sae700202.crd cards/nose.crd "$broken/cards"
sed 's/-6\.717$/-6.718/' golden/book/tables.csv > "$broken/golden/book/tables.csv"
shown=$(cd "$broken" && "$book")
status=$?
[ "$status" = 1 ] && echo "$shown" | grep -q '83 of 84 ordinates' && echo "$shown" | grep -q -- '-6\.717 .*-6\.718 .* \*$'
ok $? 'one figure that differs is counted, marked, and makes the status 1' "status $status"
finish
