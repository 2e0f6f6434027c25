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
