#!/bin/sh
# Stopped in mid-run: each command, by SIGINT, SIGTERM and SIGKILL, while its deck arrives and while
# it computes. It says so, ends by that signal, leaves the old result and nothing unfinished; a sweep
# is gone on with.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
cards=$PWD/cards LOFT_PLOT=$PWD/plot && export LOFT_PLOT
cd "$work" || exit 1
mkfifo slow

# Starts LOFT in the background, signals as they are by default: in a script's background SIGINT is
# ignored, and perl gives it back.
start() {
    (ulimit -c 0; exec perl -e '$SIG{INT} = $SIG{TERM} = "DEFAULT"; exec @ARGV' "${LOFT:?}" "$@") > out 2> err &
    run=$!
}
# Sends the signal, keeps the status.
stop() {
    kill -"$1" $run 2> /dev/null
    wait $run 2> /dev/null
    status=$?
}
unfinished() { find . -name '*.part[0-9]*' -o -name '*.old[0-9]*'; }
seen() { echo "status $status"; head -n 3 err; unfinished; }
# The run ended by its signal: left STATUS; and said so: ended STATUS WORDS
left() { [ "$status" = "$1" ] && [ -z "$(unfinished)" ] && [ "$(cat kept)" = old ]; }
ended() { left "$1" && [ "$(cat err)" = "loft: $2" ]; }

# --- while the deck arrives
head -n 12 "$cards/sae700202.crd" > begun.1970
head -n 20 "$cards/nose.crd" > begun.body
head -n 20 "$cards/sweep.crd" > begun.sweep
head -n 12 "$cards/audit-sae700202.crd" > begun.audit
while read -r deck command; do
    for pair in INT:130:interrupted TERM:143:terminated; do
        echo old > kept
        start $command slow
        exec 3> slow
        cat "begun.$deck" >&3
        sleep 0.2
        words=${pair#*:}
        stop "${pair%%:*}"
        exec 3>&-
        ended "${words%:*}" "${words#*:}" && [ ! -s out ] && [ ! -e kept.partial ] && [ ! -e slow-plots ]
        ok $? "loft $command, the deck still arriving: SIG${pair%%:*}" "$(seen)"
    done
done << 'END'
1970 run -o kept
1970 run -o kept --format csv
1970 run -o kept --arithmetic s360
body run -o kept
body export -o kept --format dxf
sweep sweep -o kept
audit audit -o kept
audit audit -o kept --format csv
body check
body plot
END

# --- while it computes: after a while, at most when it is done. A result is whole or not there. A
# signal that comes before LOFT has begun is not told.
while read -r deck result command; do
    hits=0 bad=
    for pair in INT:130:interrupted TERM:143:terminated; do
        for pause in 0.02 0.1 0.3 0.7; do
            rm -rf "$result" "$result.receipt"; echo old > kept
            start $command "$cards/$deck.crd"
            sleep $pause
            words=${pair#*:}
            stop "${pair%%:*}"
            [ "$status" = 0 ] && [ -e "$result" ] && [ -z "$(unfinished)" ] && [ ! -s err ] && continue
            [ ! -s err ] || hits=$((hits + 1))
            left "${words%:*}" && [ "$(cat err)" = "$([ -s err ] && echo "loft: ${words#*:}")" ] &&
                { [ ! -e "$result" ] || [ -d "$result" ]; } || bad="$pair $pause $(seen)"
        done
    done
    [ -z "$bad" ] && [ $hits -gt 0 ]
    ok $? "loft $command $deck.crd, stopped in mid-run" "$bad, $hits hits"
done << 'END'
fuselage table run -o table
fuselage skin.step export -o skin.step
fuselage skin.stl export -o skin.stl
fuselage frames.pdf export -o frames.pdf
audit-sae700202 figures audit -o figures
fuselage pictures plot -o pictures --format png
END

# --- a sweep is gone on with
sed 's/^SWEEP   LATIN   60/SWEEP   LATIN   24/' "$cards/sweep.crd" > sweep.crd
"$LOFT" sweep sweep.crd -o whole > /dev/null 2>&1
for pair in INT:130:interrupted TERM:143:terminated KILL:137:; do
    rm -f rows*; echo old > kept
    start sweep sweep.crd -o rows
    until [ -e rows ] || [ "$(wc -l 2> /dev/null < rows.partial)" -ge 6 ] 2> /dev/null; do sleep 0.02; done
    words=${pair#*:}
    stop "${pair%%:*}"
    said="loft: ${words#*:}; --resume goes on with rows.partial"
    [ "${pair%%:*}" = KILL ] && said=
    [ "$status" = "${words%:*}" ] && [ "$(cat err)" = "$said" ] && [ ! -e rows ] && [ -s rows.partial ] && [ -z "$(unfinished)" ]
    ok $? "a sweep ended by SIG${pair%%:*} keeps its journal and says how to go on" "$(seen)"
    "$LOFT" sweep sweep.crd -o rows --resume > out 2> err; status=$?
    [ "$status" = 0 ] && cmp -s rows whole && cmp -s rows.best.crd whole.best.crd && [ ! -e rows.partial ]
    ok $? "and is gone on with to the same bytes" "$(seen)"
done

# --- SIGKILL can't be caught: the old result is whole, and the next run does not mind
start run -o kept slow
exec 3> slow
cat begun.1970 >&3
sleep 0.2
stop KILL
exec 3>&-
[ "$status" = 137 ] && [ "$(cat kept)" = old ]
ok $? 'SIGKILL leaves the old result' "$(seen)"
"$LOFT" run "$cards/sae700202.crd" -o kept && "$LOFT" run "$cards/sae700202.crd" | cmp -s - kept
ok $? 'and the next run writes its own'

# --- what is ignored stays so
(trap '' INT TERM; exec "$LOFT" run -o ignored slow) > out 2> err &
run=$!
exec 3> slow
cat begun.1970 >&3
sleep 0.1
kill -INT $run; kill -TERM $run
sed 1,12d "$cards/sae700202.crd" >&3
exec 3>&-
wait $run; status=$?
[ "$status" = 0 ] && [ ! -s err ] && [ -s ignored ]
ok $? 'signals that are ignored do not stop it' "$(seen)"
finish
