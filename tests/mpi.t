#!/bin/sh
# `loft-mpi sweep` on 1, 2 and 4 ranks: the bytes of `loft sweep`; a rank that is killed leaves a
# journal that can be gone on with. Skipped where MPI is missing.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
mpi=${LOFT:?}-mpi
if ! command -v mpirun > /dev/null || [ ! -x "$mpi" ]; then
    echo '1..0 # SKIP there is no mpirun (make MPI=1 deps installs it, make MPI=1 builds loft-mpi)'
    exit 0
fi
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
deck=$work/nose.crd
sed 's/^SWEEP   LATIN   60/SWEEP   LATIN   24/' cards/sweep.crd > "$deck"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# Runs so many ranks of LOFT.
ranks() {
    count=$1; shift
    mpirun --oversubscribe -n "$count" "$mpi" "$@" > "$work/out" 2> "$work/err" < /dev/null
    status=$?
}

"$LOFT" sweep "$deck" -o "$work/a.csv" > "$work/summary"
for count in 1 2 4; do
    rm -f "$work"/m.*
    ranks $count sweep "$deck" -o "$work/m.csv"
    [ "$status" = 0 ] && cmp -s "$work/m.csv" "$work/a.csv" &&
        cmp -s "$work/m.csv.best.crd" "$work/a.csv.best.crd"
    ok $? "$count ranks: the same bytes" "status $status
$(cat "$work/err")"
    sed 's/m\.csv/a.csv/' "$work/out" | cmp -s - "$work/summary"
    ok $? "$count ranks: one summary" "$(cat "$work/out")"
done
ranks 4 sweep "$deck" --variant 7
"$LOFT" sweep "$deck" --variant 7 | cmp -s - "$work/out"; ok $? 'ranks without work go home' "$(cat "$work/err")"
ranks 3 sweep cards/nose.crd
[ "$status" = 1 ] && [ "$(grep -c 'no VARY card' "$work/err")" = 1 ]
ok $? 'a deck that can not be swept ends all ranks, and is said once' "status $status $(cat "$work/err")"
ranks 3 sweep "$work/none.crd"
[ "$status" = 2 ] && grep -q 'No such file' "$work/err"; ok $? 'so does a deck that is not there' "status $status"

# One rank is killed in mid-run.
for victim in 1 2; do
    rm -f "$work"/k.*
    mpirun --oversubscribe -n 3 "$mpi" sweep "$deck" -o "$work/k.csv" > /dev/null 2>&1 < /dev/null &
    run=$!
    until [ -f "$work/k.csv" ] || [ "$(wc -l 2> /dev/null < "$work/k.csv.partial")" -ge 9 ] 2> /dev/null; do
        sleep 0.01
    done
    kill -9 "$(ps -o pid= --ppid $run | sed -n "${victim}p" | tr -d ' ')" 2> /dev/null
    wait $run 2> /dev/null
    [ ! -e "$work/k.csv" ] && [ -s "$work/k.csv.partial" ]
    ok $? 'a killed rank ends the sweep; the journal stays' "$(ls "$work")"
    ranks 2 sweep "$deck" -o "$work/k.csv" --resume
    [ "$status" = 0 ] && cmp -s "$work/k.csv" "$work/a.csv"
    ok $? 'which is gone on with by another number of ranks' "status $status
$(cat "$work/err")"
done

# What ranks began a single process ends, and the other way round.
rm -f "$work"/k.*
"$LOFT" sweep "$deck" -o "$work/k.csv" > /dev/null 2>&1 &
run=$!
until [ -f "$work/k.csv" ] || [ "$(wc -l 2> /dev/null < "$work/k.csv.partial")" -ge 9 ] 2> /dev/null; do
    sleep 0.01
done
kill -9 $run 2> /dev/null
wait $run 2> /dev/null
[ -s "$work/k.csv.partial" ]; ok $? 'a single process is killed'
ranks 2 sweep "$deck" -o "$work/k.csv" --resume
cmp -s "$work/k.csv" "$work/a.csv"; ok $? 'ranks go on with what a single process began' "$(cat "$work/err")"
ranks 2 sweep "$deck" -o /dev/full
[ "$status" = 2 ] && grep -q 'No space left on device' "$work/err"
ok $? 'a full device ends all ranks' "status $status $(cat "$work/err")"
finish
