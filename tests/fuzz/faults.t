#!/bin/sh
# What the system refuses: services that fail at any call, no memory, no disk, files too large,
# programs killed. The message names the cause, the status is 2, the old result stays, nothing is
# left behind. FAULTS=N: that many places for each fault, else 4.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'umount "$work/small" 2> /dev/null; rm -rf "$work"' EXIT
places=${FAULTS:-4}
plot=$PWD/plot deck=$work/deck
grep -v '^WATERLN\|^BUTTOCK\|^OBLIQUE\|^PLANE' tests/fuzz/seeds/quarter.crd > "$deck"
if ! cc -shared -fPIC -O1 -o "$work/faults.so" tests/fuzz/faults.c -ldl 2> "$work/err"; then
    ok 0 'injected faults # SKIP no C compiler, or another system'
    finish; exit
fi
cd "$work" || exit 1
export LOFT_PLOT="$plot" OMP_NUM_THREADS=2
"${LOFT:?}" run --format csv "$deck" > want
"$LOFT" export "$deck" -o want.dxf > want.receipt
case "$LOFT" in *sanitize*) preload= ;; *) preload=$work/faults.so ;; esac
if [ -z "$preload" ] || ! LD_PRELOAD=$preload FAULT=read "$LOFT" run "$deck" 2>&1 | grep -q 'Input/output error'; then
    ok 0 'injected faults # SKIP the system preloads nothing'
    finish; exit
fi
injected=0

# A run with a fault: fault 'NAME=VALUE...' COMMAND...; a result that was there says old.
fault() {
    faults=$1; shift
    echo old > kept.csv; echo old > kept.dxf; echo old > kept.dxf.receipt
    (ulimit -c 0; env LD_PRELOAD="$preload" $faults "$LOFT" "$@") > out 2> err < /dev/null
    status=$?
    injected=$((injected + 1))
}
# Nothing unfinished, no spare copy.
tidy() { [ -z "$(find . -name '*.part*' -o -name '*.old[0-9]*')" ]; }
seen() { echo "$faults: status $status"; head -n 4 err; ls; }
# The run failed with one message and left all as it was.
refused() {
    [ "$status" = 2 ] && grep -qF -- "$1" err && ! grep -q 'at fault' err && tidy &&
        [ "$(cat kept.csv kept.dxf kept.dxf.receipt)" = "$(printf 'old\nold\nold')" ]
}
# It was refused, or, where the fault did no harm, all is done.
whole() {
    refused "$1" || { [ "$status" = 0 ] && tidy && { cmp -s kept.csv want || cmp -s out want; } && [ ! -s err ]; }
}

# --- a service fails once, and from then on
for pair in write:28:'No space left' write:5:'Input/output' fsync:5:'Input/output' fsync:28:'No space' \
    fclose:122:'Disk quota' rename:13:'Permission denied' read:5:'Input/output' fopen:24:'Too many open'; do
    name=${pair%%:*} words=${pair##*:} number=${pair#*:}; number=${number%:*}
    good=0 hits=0
    for at in $(seq "$places"); do
        for ever in '' EVER=1; do
            fault "FAULT=$name AT=$at ERRNO=$number $ever" run --format csv -o kept.csv "$deck"
            whole "$words" || { good=1; seen > bad; }
            [ "$status" = 0 ] || hits=$((hits + 1))
        done
    done
    [ $good = 0 ] && [ $hits -gt 0 ]
    ok $? "run: $name fails with error $number, $hits times" "$(cat bad 2> /dev/null)"
    good=0 hits=0
    for at in $(seq "$places"); do
        fault "FAULT=$name AT=$at ERRNO=$number" export "$deck" -o kept.dxf
        refused "$words" || { [ "$status" = 0 ] && cmp -s kept.dxf want.dxf && tidy; } || { good=1; seen > bad; }
        [ "$status" = 0 ] || hits=$((hits + 1))
    done
    # Standard output, last, gets the receipt; when only that fails the files are there.
    [ $hits -gt 0 ] && { [ $good = 0 ] || { [ $name = write ] && grep -q 'standard output' bad; }; }
    ok $? "export of a drawing and its receipt: $name fails with error $number, $hits times" "$(cat bad 2> /dev/null)"
done
fault 'FAULT=zero' run --format csv -o kept.csv "$deck"
refused 'kept.csv: '; ok $? 'a write that takes nothing, ever' "$(seen)"
fault 'FAULT=short' run --format csv -o kept.csv "$deck"
[ "$status" = 0 ] && cmp -s kept.csv want; ok $? 'writes that take a few bytes' "$(seen)"
for number in 4 11; do
    fault "FAULT=write AT=1 ERRNO=$number" run --format csv -o kept.csv "$deck"
    [ "$status" = 0 ] && cmp -s kept.csv want; ok $? "a write that fails for now, error $number" "$(seen)"
    fault "FAULT=read AT=1 ERRNO=$number" run --format csv -o kept.csv "$deck"
    [ "$status" = 0 ] && cmp -s kept.csv want; ok $? "a read that fails for now, error $number" "$(seen)"
done

# --- memory: the first allocations are the runtime's own, before LOFT begins
total=$(env COUNT=1 FAULT=malloc AT=1000000000 LD_PRELOAD="$preload" "$LOFT" run --format csv "$deck" 2>&1 > out |
    sed -n 's/^calls //p')
good=0 hits=0
for i in $(seq $((2*places))); do
    fault "FAULT=malloc AT=$((60 + (i - 1)*(total - 60)/(2*places)))" run --format csv -o kept.csv "$deck"
    { [ "$status" = 2 ] && grep -q '^loft: out of memory' err && tidy && [ "$(cat kept.csv)" = old ]; } ||
        { [ "$status" = 0 ] && cmp -s kept.csv want; } || { good=1; seen > bad; }
    [ "$status" = 0 ] || hits=$((hits + 1))
done
[ $good = 0 ] && [ $hits -gt 0 ]
ok $? "run: no memory at $hits of $((2*places)) places among $total" "$(cat bad 2> /dev/null)"
for limit in 60000 80000; do
    echo old > kept.csv
    (ulimit -v $limit; "$LOFT" run --format csv -o kept.csv "$deck") > out 2> err; status=$?
    { [ "$status" != 0 ] && [ "$(cat kept.csv)" = old ] && tidy; } || { [ "$status" = 0 ] && cmp -s kept.csv want; }
    ok $? "run in $limit KiB of address space" "$(seen)"
done

# --- files too large, disks too small
sed 's/^STATION.*/WATERLN -16.    0.      20.     .01/' "$deck" > long.crd
echo old > kept.csv
(ulimit -f 40; "$LOFT" run --format csv -o kept.csv long.crd) > out 2> err; status=$?
[ "$status" = 2 ] && grep -q '^loft: kept.csv: File too large' err && [ "$(cat kept.csv)" = old ] && tidy
ok $? 'a result above the limit of file size' "$(seen)"
(ulimit -f 40; "$LOFT" run --format csv long.crd > big) 2> err; status=$?
[ "$status" = 2 ] && grep -q '^loft: standard output: File too large' err
ok $? 'standard output above it' "$(seen)"
mkdir small
if mount -t tmpfs -o size=32k tmpfs small 2> /dev/null; then
    echo old > small/kept.csv
    "$LOFT" run --format csv -o small/kept.csv long.crd > out 2> err; status=$?
    [ "$status" = 2 ] && grep -q '^loft: small/kept.csv: No space left on device' err && [ "$(cat small/kept.csv)" = old ] && tidy
    ok $? 'a disk that is full' "$(seen)"
    "$LOFT" plot long.crd -o small/plots > out 2> err; status=$?
    [ "$status" = 2 ] && grep -q 'No space left on device' err && tidy
    ok $? 'pictures on a disk that is full' "$(seen)"
    umount small
else
    ok 0 'a disk that is full # SKIP nothing can be mounted here'
fi

# --- killed in mid-run, ended by time, by quit
for signal in QUIT:131 SEGV:139 XCPU:152; do
    echo old > kept.csv; rm -f slow; mkfifo slow
    (ulimit -c 0; exec perl -e '$SIG{INT} = $SIG{QUIT} = "DEFAULT"; exec @ARGV' "$LOFT" run --format csv -o kept.csv slow) > out 2> err &
    run=$!
    exec 3> slow
    head -n 4 "$ROOT/tests/fuzz/seeds/conic.crd" >&3
    for i in $(seq 100); do [ -n "$(find . -name 'kept.csv.part*')" ] && break; sleep 0.05; done
    kill -"${signal%:*}" $run; wait $run 2> /dev/null; status=$?
    exec 3>&-
    [ "$status" = "${signal#*:}" ] && [ "$(cat kept.csv)" = old ] && tidy
    ok $? "SIG${signal%:*} keeps the old result and leaves nothing" "$(seen)"
done
mkdir tools
printf '#!/bin/sh\nkill -KILL $$\n' > tools/gnuplot; chmod +x tools/gnuplot
(PATH=$work/tools:$PATH; "$LOFT" plot "$deck" -o plots) > out 2> err; status=$?
[ "$status" = 2 ] && grep -q 'gnuplot did not draw it (its exit status is 137)' err && tidy
ok $? 'gnuplot is killed' "$(seen)"
printf '#!/bin/sh\nkill -INT 0\n' > tools/gnuplot
(PATH=$work/tools:$PATH; exec perl -e 'setpgrp(0, 0); $SIG{INT} = "DEFAULT"; exec @ARGV' "$LOFT" plot "$deck" -o plots) > out 2> err; status=$?
[ "$status" = 130 ] && tidy
ok $? 'an interrupt while gnuplot draws ends LOFT by that signal' "$(seen)"

# --- standard input that is closed
"$LOFT" run --format csv - <&- > out 2> err; status=$?
[ "$status" = 2 ] && grep -q '^loft: .*Bad file descriptor' err
ok $? 'a deck from a closed standard input' "$(seen)"
"$LOFT" check - <&- > out 2> err; status=$?
[ "$status" = 2 ] && grep -q '^loft: .*Bad file descriptor' err
ok $? 'check of a closed standard input' "$(seen)"
echo "# $injected faults injected, nothing lost"
finish
