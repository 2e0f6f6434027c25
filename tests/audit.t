#!/bin/sh
# loft audit on the scanned tables of SAE 700202, against the tables as they were restored by hand
# (golden/book): every damaged figure found, none accused, those with one bad character restored, and
# the deck of 1970 back. Then what a clumsy user does.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
loft=${LOFT:?} cards=$PWD/cards book=$PWD/golden/book
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# Counts the check that a text is as expected: TEXT EXPECTED NAME
same() {
    [ "$1" = "$2" ]
    ok $? "$3" "$1"
}

# --- the book -------------------------------------------------------------------------------------
"$loft" audit --format csv "$cards/audit-sae700202.crd" > book.csv
ok $? 'the scanned tables are audited'
# Each figure of the book beside what the audit says of it: verdict, restored, corrected, scanned.
awk -F, 'FNR == 1 { file++; next }
    file == 1 { split($2, name, " "); key = name[1] " " toupper(name[2])
        if ($1 == 4) { key = name[1] name[2]; if (key == "STA0") key = toupper(name[3]) }
        axis = tolower($3) ($2 == "MHB side" && $5 == "root1" ? " 2" : "")
        at[key, axis, $4 + 0] = $6 "," $7; next }
    $4 ~ /^[xy]/ { key = $1 ($2 == "STATION" ? "" : " " $2)
        if (!((key, $4, $5 + 0) in at)) { print "missing " $0; next }
        print $11 "," at[key, $4, $5 + 0] "," $12 }' "$book/tables.csv" book.csv > figures
same "$(grep -c . figures) $(grep -c missing figures)" '84 0' 'all 84 ordinates of the book are in it'
awk -F, '$2 == $3 && $1 != "agrees"' figures > accused
same "$(cat accused)" '' 'no sound figure is accused'
awk -F, '$2 != $3 && $1 == "agrees"' figures > missed
same "$(cat missed)" '' 'no damaged figure is passed'
# One character differs: changed, or one more.
awk -F, 'function one(a, b, i, n) {
        if (length(a) == length(b)) {
            for (i = 1; i <= length(a); i++) n += substr(a, i, 1) != substr(b, i, 1)
            return n == 1 }
        for (i = 1; i <= length(a); i++)
            if (substr(a, 1, i - 1) substr(a, i + 1) == b) return 1
        return 0 }
    $2 != $3 && one($2, $3) { n++; if ($3 + 0 == $4 + 0) right++ }
    END { print n, right }' figures > restored
same "$(cat restored)" '20 20' 'those with one bad character are restored, all 20'
# Tables 1 and 3 and the coefficients: scanned, restored, verdict, corrected.
awk -F, 'FNR == 1 { file++; next }
    file == 1 { split($2, name, " "); key = name[1] " " toupper(name[2])
        if ($1 == 3) { key = name[1] name[2]; if (key == "STA0") key = toupper(name[3]) }
        at[key, $3] = $4 "," $5; next }
    $4 ~ /^(exact|about) / { key = $1 ($2 == "STATION" ? "" : " " $2); split($4, what, " ")
        if ((key, what[2]) in at && $11 != "") print key, what[2] "," at[key, what[2]] "," $11 "," $12 }' \
    "$book/inputs.csv" book.csv > inputs
same "$(awk -F, '$2 != $3 && $4 == "agrees" && $1 !~ / S3$/' inputs)" '' \
    'no damaged number of Tables 1 and 3 is passed'
same "$(awk -F, '$2 == $3 && $4 != "agrees"' inputs)" '' 'no sound one is accused'
same "$(awk -F, '$4 == "suspect" { printf "%s;", $1 }' inputs)" \
    'MHB SIDE A;MHB SIDE B;LSH PLAN Y2;CONTOUR Y2;FLOOR Y1;FLOOR Y2;STA10 YI;STA20 Y3;STA25 Y1;STA25 YI;' \
    'the damaged ones are found'
"$loft" audit --format deck "$cards/audit-sae700202.crd" > deck.crd
same "$(awk '/^-30/ { printf "%s ", $8 }' deck.crd)" '0.0523 -0.0697 -0.0871 0.1405 0.1316 ' \
    'the four-digit S3 of Table 1 are recovered'
"$loft" run --arithmetic s360 deck.crd > again.lst && \
    "$loft" run --arithmetic s360 "$cards/sae700202.crd" > first.lst
same "$(diff first.lst again.lst | grep -c '^[<>]')" 4 \
    'the deck that it gives prints the pages of 1970, but for two rows beyond the sections'

# S1 known to three decimals only: an interval, and both pairs of LSH plan.
sed -n '/^AUDIT   LSH     PLAN/,/^AUDIT   CONTOUR/p' "$cards/audit-sae700202.crd" | sed '$d' | \
    sed 's/Y2      -9.0/Y2      9.0/; s/S1      0.404//; 2a ABOUT   S1      0.404' > open.crd
sed -i '1a PRINTED 1970' open.crd
"$loft" audit open.crd > open.lst
sed -n '/^S1 AND S3/,/^CARD/p' open.lst | tr -s '\n ' ' ' | \
    grep -q '^S1 AND S3 TOGETHER:.*0.4035 WITH 0.1317.*0.4040 WITH 0.1316'
ok $? 'with S1 to three decimals both pairs of the lower shoulder are named' \
    "$(sed -n '/TOGETHER/,/CARD/p' open.lst)"

# --- threads --------------------------------------------------------------------------------------
for count in 1 2 7; do
    for format in listing csv deck; do
        OMP_NUM_THREADS=$count "$loft" audit --format $format "$cards/audit-sae700202.crd"
    done > all.$count
done
cmp -s all.1 all.2 && cmp -s all.1 all.7
ok $? 'one thread, two and seven find the same, byte for byte'

# --- forms ----------------------------------------------------------------------------------------
"$loft" audit --format csv book.csv > twice.csv && cmp -s book.csv twice.csv
ok $? 'its CSV can be audited again and gives the same'
"$loft" plot "$cards/audit-sae700202.crd" -o pictures > names 2> err
[ $? = 0 ] && [ "$(grep -c 'pictures/audit-.*svg' names)" = 14 ] && [ ! -s err ]
ok $? 'a picture for each table and axis' "$(cat names err)"
cat > inches.crd <<'DECK'
AUDIT   SHEER   PLAN
PRINTED ROUNDED FIE
0.      0-0-0   10.     1-2-1   20.     1-8-2   30.     1-11-6  40.     2-1-4
50.     2-3-1   60.     2-3-7   70.     2-4-0   80.     2-3-3   90.     2-2-1
DECK
"$loft" audit inches.crd > inches.lst
grep -q 'FEET-INCHES-EIGHTHS\|10 FIGURES' inches.lst
ok $? 'feet, inches and eighths are read' "$(cat inches.lst)"

# --- a damaged table of one's own -------------------------------------------------------------------
# The conic from 0, 0 at slope 2 through 10, 8 to 40, 14 at slope .1, to two decimals, cut off; 8.00,
# 11.43 and 12.80 are damaged. Where its shoulder point was nobody knows.
cat > own.crd <<'DECK'
AUDIT,WL3,PLAN
PRINTED,TRUNCATE
EXACT,X1,0.,Y1,0.,X3,40.
0,0.00,2,2.86,4,4.67,6,6.02,8,7.10,10,3.00,12,8.76,14,9.43,16,10.01,18,10.54,20,11.01
22,11.82,24,11.82,26,12.17,28,12.50,30,72.80,32,13.07,34,13.33,36,13.57,38,13.79,40,14.00
DECK
"$loft" audit own.crd > own.lst
same "$(awk '$1 == "X" && $6 == "SUSPECT" { print $2, $3, $7 }' own.lst | tr '\n' ' ')" \
    '10 3.00 8.00 22 11.82 11.43 30 72.80 12.80 ' 'what is damaged is found and restored'
same "$(sed -n '/^CARD/,/^$/p' own.lst | sed 1d | tr -s ' ')" '0. 0. 2. 20. 11.012 40. 14. 0.1 2.' \
    'the card has the slopes of the line, its shoulder point where it may be'
awk 'BEGIN { q = "\""; print q "table" q "," q "view" q "," q "at" q "," q "what" q "," q "along" q "," q "printed" q }
    /^[0-9]/ { n = split($0, f, ","); for (i = 1; i < n; i += 2) print q "WL3" q "," q "PLAN" q "," q q ",x," f[i] "," q f[i + 1] q }
    /^PRINTED/ { print "WL3,PLAN,," q "printed truncate" q ",," }
    /^EXACT/ { print "WL3,PLAN,,exact X1,," q "0." q "\r\nWL3,PLAN,,exact Y1,,0.\r\nWL3,PLAN,,exact X3,," q "40." q }' \
    own.crd | sed 's/\r*$/\r/' > own.csv
"$loft" audit own.csv --format csv > from.csv 2> err
"$loft" audit own.crd --format csv > from.crd
awk -F, '{ print $4, $5, $6, $7, $8, $9, $10, $11, $12 }' from.csv | sort > csv.sorted
awk -F, '{ print $4, $5, $6, $7, $8, $9, $10, $11, $12 }' from.crd | sort | cmp -s - csv.sorted
ok $? 'as CSV with quotes, as a spreadsheet writes it, it is the same' "$(diff from.csv from.crd) $(cat err)"

# --- faults ---------------------------------------------------------------------------------------
"$loft" audit "$cards/nose.crd" 2> err
same "$? $(cut -d, -f1 err | sed 's/.*nose/nose/')" '2 nose.crd is no deck of printed tables' \
    'a body deck is refused'
"$loft" run "$cards/audit-sae700202.crd" 2> err
same "$? $(sed 's/.*crd //' err)" '2 is a deck of printed tables; loft audit finds what is right in them' \
    'run sends printed tables to audit'
printf 'AUDIT   A       SIDE\n5.      1.x\n' > bad.crd
"$loft" audit bad.crd > out 2> err
same "$? $(grep error err | cut -d: -f1-4)" '1 bad.crd:2:11-11: error' \
    'letters in a figure are a fault of their columns'
"$loft" check bad.crd 2> err
same "$? $(grep -c error err)" '1 1' 'check reads printed tables, too'
printf 'table,view,at,what,along,printed\nA,SIDE,,x,five,1.0\n' > bad.csv
"$loft" audit bad.csv > out 2> err
same "$? $(grep error err | cut -d: -f1-4)" '1 bad.csv:2:11-14: error' 'and in CSV'
"$loft" audit 2> err
same "$? $(cat err)" '2 loft: loft audit needs a deck (- is standard input)' 'a deck is needed'
"$loft" audit - < "$cards/audit-sae700202.crd" | grep -q '158 FIGURES'
ok $? 'standard input will do'
finish
