#!/bin/sh
# Every command at the limits of what it may be given: numbers that are none or too large, endless
# lines, points by the million, decks and places that are none, names that a shell would choke on.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
chmod 755 "$work"
cards=$PWD/cards seeds=$PWD/tests/fuzz/seeds LOFT_PLOT=$PWD/plot && export LOFT_PLOT
cd "$work" || exit 1

# Runs LOFT, keeps output, messages and status.
loft() {
    "${LOFT:?}" "$@" > out 2> err < /dev/null
    status=$?
}
seen() { echo "status $status"; head -n 4 err | cut -c1-300; }
# The last run failed with a status and words.
said() {
    [ "$status" = "$1" ] && grep -q -- "$2" err && ! grep -q 'at fault' err && [ -z "$(find . -name '*.part*')" ]
    ok $? "$3" "$(seen)"
}
# A deck for each command, and the command: where is the deck, where is the result.
commands() {
    cat << 'END'
conic run -o @
conic run --arithmetic s360 -o @
quarter run --format csv -o @
quarter export -o @ --format dxf
sweep sweep -o @
audit audit -o @
audit audit --format deck -o @
END
}
each() { commands | while read -r deck command; do "$@" "$seeds/$deck.crd" "$command"; done; }
# In the place of @ stands a name.
to() { echo "$2" | sed "s|@|$1|"; }

# --- numbers: as a 1970 card has them, and as a body deck has them
conic() { printf '%8s%8s%8s%8s%8s%8s%8s%8s%6s\n' "$@" > number.crd; }
body() {
    printf '%s\n' 'LINE,UCL,SIDE' "0.,$1,0.,$2,$3,160.,30.,-.2" 'LINE,MHB,SIDE,0.' 'LINE,MHB,PLAN' \
        '0.,30.,0.,80.,29.,160.,24.,-.15' 'LINE,SHO,SIDE' '0.,32.,0.,80.,30.4,160.,24.,-.16' 'LINE,SHO,PLAN' \
        '0.,18.,0.,80.,17.4,160.,14.4,-.09' 'SECTION,UPPER,UCL,SHO,MHB,0.,999.999' "$4" > number.crd
}
for number in 1.E-310 5.E-324 1.E300 -1.E308 1.8E308 1.E400 1.E-400 1.E9999; do
    for form in '--format csv' '' '--arithmetic s360'; do
        conic 0. 0. 0. "$number" .4 2. 1. 1. .5
        loft run $form number.crd
        said 1 'number.crd:1:[0-9]*-32: error: X2: the number is out of range' "run $form: X2 of $number"
    done
    body 40. 80. "$number" 'STATION,80.'
    loft run --format csv number.crd
    said 1 'number.crd:2:.*: error: .*Y2.*out of range' "run of a body deck: Y2 of $number"
done
for number in NaN Inf -Inf nan Infinit 1.E 0x1.8 1,5 1..5; do
    conic 0. 0. 0. 1. "$number" 2. 1. 1. .5
    loft run --format csv number.crd
    said 1 'number.crd:1:[34].-..: error: Y2: ' "run: Y2 of $number"
    [ "$number" = 1,5 ] && continue
    body 40. 80. "$number" 'STATION,80.'
    loft run --format csv number.crd
    said 1 'number.crd:2:.*: error: ' "run of a body deck: Y2 of $number"
done
conic 0. 0. 0. 1.E75 .4E75 2.E75 1.E75 1. 1.E74
loft run --format csv number.crd
[ "$status" = 0 ] && [ "$(wc -l < out)" = 22 ] && ! grep -qi 'nan\|infinity' out
ok $? 'coordinates of 1e75 have their conic' "$(seen)"
conic 0. 0. 0. 1.E-75 .4E-75 2.E-75 1.E-75 1. 1.E-76
loft run --format csv number.crd
[ "$status" = 0 ] && [ "$(wc -l < out)" = 22 ] && tail -n 1 out | grep -q '^1,X,2e-75,1e-75,1,'
ok $? 'so have those of 1e-75' "$(seen)"

# --- points by the million: refused with the count and the way out
for form in '--format csv' ''; do
    conic 0. 0. 0. 1. .4 2. 1. 1. 2.E-6
    loft run $form number.crd
    said 1 'makes 1000001 rows; LOFT makes at most 100000 in a table: take an increment of' "run $form: a million rows"
done
loft run --arithmetic s360 number.crd
said 1 'the X table would have [0-9]* rows, and the most is 100000' 'run --arithmetic s360: a million rows'
for cut in 'WATERLN,8.,40.,120.,.00008' 'BUTTOCK,8.,40.,120.,.00008' 'OBLIQUE,40.,0.,120.,30.,.00008' \
    'STATION,40.,120.,.00008' 'POINTS,NUMBER,1000000
STATION,80.' 'POINTS,LENGTH,.00003
STATION,80.' 'POINTS,CHORD,1.E-15
STATION,80.'; do
    body 40. 80. 38. "$cut"
    loft run --format csv number.crd
    said 1 ': error: .*\(most\|more than\|2 to\) 100000' "run of a body deck: $(echo "$cut" | head -n 1)"
    loft export number.crd -o many.dxf
    [ "$status" != 0 ] && grep -q ': error: .*\(most\|more than\|2 to\) 100000' err
    ok $? "and its export" "$(seen)"
done

# --- lines of 100,000 characters
long=$(printf '%0100000d' 0 | tr 0 9)
for line in "$long" "* $long" "TITLE   $long" "+,$long" "STATION,$long" ".$long"; do
    for deck in conic quarter sweep audit; do
        { sed '$d' "$seeds/$deck.crd"; echo "$line"; tail -n 1 "$seeds/$deck.crd"; } > long.crd
        case $deck in audit) command=audit ;; sweep) command=sweep ;; *) command='run --format csv' ;; esac
        (ulimit -t 60; exec "$LOFT" $command long.crd) > out 2> err < /dev/null; status=$?
        [ "$status" -le 1 ] && ! grep -q '.\{2000\}' err && { [ "$status" = 0 ] || grep -q ': error: ' err; }
        ok $? "$deck with a line of 100,000: $(echo "$line" | cut -c1-8)" "$(seen)"
    done
done

# --- results on a full device, below a folder that may not be written, in place of a folder
full() {
    loft $(to /dev/full "$2") "$1"
    said 2 '/dev/full: No space left on device' "$2 on a full device"
    "$LOFT" $(to - "$2") "$1" > /dev/full 2> err < /dev/null; status=$?
    said 2 'No space left on device' "$2 to a full standard output"
    { "$LOFT" $(to - "$2") "$1" 2> err < /dev/null; echo $? > ended; } | head -c 1 > out
    status=$(cat ended)
    [ "$status" = 141 ] || [ "$status" = 0 ]; [ $? = 0 ] && ! grep -q '^loft:' err
    ok $? "$2 into a pipe that is closed" "$(seen)"
    mkdir -p folder
    loft $(to folder "$2") "$1"
    said 2 'folder\(.partial\)\?: Is a directory\|folder is a folder' "$2 in place of a folder"
    loft $(to none/of/it "$2") "$1"
    said 2 'No such file or directory' "$2 below no folder"
}
each full > results; cat results > full.tap; checked=$(grep -c '^ok\|^not ok' full.tap)
! grep -q '^not ok' full.tap; ok $? "results that can't be written, $checked of them" "$(grep -A4 '^not ok' full.tap)"

# --- decks that are none; those that come through a FIFO
mkdir -p folder; mkfifo fifo
none() {
    for name in folder missing.crd ''; do
        loft $(to result "$2") "$name"
        said 2 '^loft: ' "$2 of '$name'"
        [ ! -e result ]; ok $? 'and nothing is left'
    done
    loft $(to want "$2") "$1"
    cat "$1" > fifo & loft $(to got "$2") fifo; wait
    [ "$status" = 0 ] && { cmp -s want got || [ "$(sed 's/fifo/DECK/' got | grep -c .)" = "$(grep -c . want)" ]; }
    ok $? "$2 of a FIFO" "$(seen)"
    rm -f want* got*
}
each none > none.tap; checked=$(grep -c '^ok\|^not ok' none.tap)
! grep -q '^not ok' none.tap; ok $? "decks that are none, and FIFOs, $checked of them" "$(grep -A4 '^not ok' none.tap)"

# --- what may not be read or written, for anyone but root
as_nobody=
if [ "$(id -u)" = 0 ]; then
    as_nobody='setpriv --reuid=65534 --regid=65534 --clear-groups'
    cp "$LOFT" ./loft-for-all && chmod 755 loft-for-all
    $as_nobody ./loft-for-all --version > /dev/null 2>&1 || as_nobody=none
fi
program=$LOFT; [ -z "$as_nobody" ] || program=$work/loft-for-all
forbidden() {
    cp "$1" secret.crd && chmod 000 secret.crd
    cp "$1" open.crd && chmod 644 open.crd
    $as_nobody "$program" $(to /dev/null "$2") secret.crd > out 2> err < /dev/null; status=$?
    said 2 'secret.crd: Permission denied' "$2 of a deck without permission"
    mkdir -p shut && chmod u+w shut && echo old > shut/result && chmod 644 shut/result && chmod 555 shut
    $as_nobody "$program" $(to shut/result "$2") open.crd > out 2> err < /dev/null; status=$?
    said 2 'shut/result\(.partial\)\?: Permission denied' "$2 in a folder without permission"
    [ "$(cat shut/result)" = old ]; ok $? 'the old file stays'
    chmod u+w shut secret.crd; rm -f secret.crd open.crd
}
if [ "$as_nobody" = none ]; then
    ok 0 'decks and folders without permission # SKIP run as root, and no setpriv to be someone else'
else
    each forbidden > forbidden.tap; checked=$(grep -c '^ok\|^not ok' forbidden.tap)
    ! grep -q '^not ok' forbidden.tap
    ok $? "decks and folders without permission, $checked of them" "$(grep -A4 '^not ok' forbidden.tap)"
fi

# --- stacks and threads of any size
deck=$seeds/conic.crd
"$LOFT" run --format csv "$deck" > want
least() {
    sed 's/STATION.*/STATION,10./' "$seeds/quarter.crd" > small.crd
    for command in "run --format csv $deck" "run --arithmetic s360 $deck" 'run small.crd' 'export small.crd -o small.step'; do
        ("$@"; exec "$LOFT" $command) > out 2> err < /dev/null; status=$?
        [ "$status" = 0 ]; ok $? "$*: loft $command" "$(seen)"
    done
}
if [ "${MODE:-}" != sanitize ] && (ulimit -s 512) 2> /dev/null; then
    least ulimit -s 512
    least export OMP_STACKSIZE=512k OMP_NUM_THREADS=2
fi
if (ulimit -s 300 && "$LOFT" --version > /dev/null 2>&1; [ $? = 2 ]); then
    (ulimit -s 300; exec "$LOFT" run -o never "$deck") > out 2> err < /dev/null; status=$?
    said 2 '^loft: the stack is limited to 300 KiB (ulimit -s); LOFT needs 512$' 'a stack that is too small'
fi
for size in 64k 100 1B; do
    OMP_STACKSIZE=$size "$LOFT" run -o never "$deck" > out 2> err < /dev/null; status=$?
    said 2 '^loft: OMP_STACKSIZE gives threads stacks of [0-9]* KiB; LOFT needs 512$' "stacks of $size for threads"
done
[ ! -e never ]; ok $? 'and nothing is left'
for number in 100000 2147483647; do
    OMP_NUM_THREADS=$number "$LOFT" run --format csv "$deck" > out 2> err < /dev/null; status=$?
    [ "$status" = 0 ] && cmp -s out want; ok $? "$number threads are asked for" "$(seen)"
done

# --- standard output that is closed is named
while read -r name command; do
    "$LOFT" $(to result "$command") "$seeds/$name.crd" > /dev/null 2> err && "$LOFT" $(to result "$command") "$seeds/$name.crd" >&- 2> err
    status=$?
    said 2 '^loft: standard output: ' "$command with standard output closed"
    rm -rf result*
done << 'END'
quarter run
quarter export --format dxf -o @
sweep sweep -o @
END

# --- names with control bytes: messages stay one line each, and a terminal is not told anything
name=$(printf 'a\nloft: b\033[2J')
loft run "$name"
[ "$status" = 2 ] && [ "$(cat err)" = 'loft: a?loft: b?[2J: No such file or directory' ]
ok $? 'a deck that is missing, with control bytes in its name' "$(seen)"
echo nonsense > "$name"
for command in run check; do
    loft $command "$name"
    [ "$status" = 1 ] && grep -q '^a?loft: b?\[2J:1' err && [ "$(grep -c . err)" -le 4 ]
    ok $? "$command of a faulty one" "$(seen)"
done
loft export "$seeds/quarter.crd" -o "$name.dxf"
[ "$status" = 0 ] && grep -q '^FILE       a?loft: b?\[2J.dxf$' out; ok $? 'the receipt of a drawing called so' "$(seen)"

# --- time grows with the deck, not with its square
{ printf 'TITLE,MANY LINES\nUNITS,INCHES\n'
    for i in $(seq 4000); do printf 'LINE,L%d,SIDE\n-30.,-10.,.114,0.,-7.1,50.,-4.,.0523\n' "$i"; done; } > many.crd
(ulimit -t 60; exec "$LOFT" run many.crd) > out 2> err < /dev/null; status=$?
[ "$status" -le 1 ] && [ "$(grep -c '^ *[0-9]*  LINE,L' out)" = 4000 ]
ok $? 'a listing of 8,000 cards' "$(seen)"

# --- names and titles
odd="a 'b' \"c\" \$(touch pwned) \`touch pwned\`; touch pwned & é ☃ \\n %s *"
for deck in conic quarter sweep audit; do
    { grep -v '^TITLE' "$seeds/$deck.crd" | sed -n '/^\*/p'; echo "TITLE   A 'B' \"C\" \$(touch pwned) \`touch pwned\` é"
        grep -v '^TITLE' "$seeds/$deck.crd" | sed '/^\*/d'; } > "$odd.crd"
    case $deck in
    conic | quarter) set -- run ;;
    sweep) set -- sweep ;;
    audit) set -- audit ;;
    esac
    loft "$@" "$odd.crd" -o "$odd.out"
    [ "$status" = 0 ] && [ -s "$odd.out" ] && [ ! -e pwned ]
    ok $? "$* of $deck, deck and result called oddly" "$(seen)"
    if [ $deck != sweep ] && command -v gnuplot > /dev/null; then
        loft plot "$odd.crd" -o "$odd plots"
        [ "$status" = 0 ] && [ ! -s err ] && [ -n "$(ls "$odd plots"/*.svg)" ] && [ ! -e pwned ] && [ ! -e "$odd plots/pwned" ]
        ok $? "plot of $deck, deck and folder called oddly" "$(seen)"
        rm -rf "$odd plots"
    fi
    [ $deck = conic ] || [ $deck = quarter ] || continue
    for ending in svg pdf dxf igs step nc; do
        loft export "$odd.crd" -o "$odd.$ending"
        [ "$status" = 0 ] && [ -s "$odd.$ending" ] && [ -s "$odd.$ending.receipt" ] && [ ! -e pwned ]
        ok $? "export of $deck as $ending, called oddly" "$(seen)"
    done
done
finish
