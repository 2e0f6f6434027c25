#!/bin/sh
# Results that appear whole or not at all, decks that can't be read, signals, closed and full ends.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
work=$(mktemp -d) && trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
chmod 755 "$work"
deck=$PWD/cards/sae700202.crd
"${LOFT:?}" run --format csv "$deck" > "$work/want"
cd "$work" || exit 1

# Runs LOFT, keeps output, messages and status.
loft() {
    "$LOFT" "$@" > out 2> err < /dev/null
    status=$?
}

# The last run failed with status 2 and one message with these words.
failed() {
    [ "$status" = 2 ] && [ "$(wc -l < err)" = 1 ] && grep -q '^loft: ' err && grep -qF -- "$1" err
    ok $? "$2" "status $status, $(cat err)"
}

# There is no unfinished file.
tidy() {
    [ -z "$(find . -name '*.part*')" ]
    ok $? "$1 leaves no unfinished file" "$(find . -name '*.part*')"
}

# --- results
loft run --format csv -o new "$deck"
[ "$status" = 0 ] && [ ! -s out ] && [ ! -s err ] && cmp -s new want
ok $? '-o writes the file and nothing else'
(umask 027 && "$LOFT" run --format csv -o masked "$deck") && [ "$(ls -l masked | cut -c1-10)" = '-rw-r-----' ]
ok $? 'a new file has the permissions that the umask leaves'
echo old > replaced
loft run --format csv -o replaced "$deck"
[ "$status" = 0 ] && cmp -s replaced want
ok $? '-o replaces a file'
loft run --format csv -o partly "$ROOT/cards/faults.crd"
[ "$status" = 1 ] && grep -q '^34,X' partly
ok $? 'a deck with a bad card has its result whole'
echo old > real && ln -s real link
loft run --format csv -o link "$deck"
[ "$status" = 0 ] && [ -L link ] && cmp -s real want
ok $? 'a link is written through'
ln -s nowhere dangling
loft run --format csv -o dangling "$deck"
[ "$status" = 0 ] && [ -L dangling ] && cmp -s nowhere want
ok $? 'a link to a file not there yet is written through'
"$LOFT" run --format csv -o /dev/stdout "$deck" | cmp -s - want
ok $? '-o /dev/stdout goes to standard output'
"$LOFT" run --format csv -o - "$deck" | cmp -s - want
ok $? '-o - goes to standard output'
mkfifo fifo
cat fifo > through & loft run --format csv -o fifo "$deck"; wait
[ "$status" = 0 ] && [ -p fifo ] && cmp -s through want
ok $? 'a FIFO is written through'
odd="a result's \"name\".csv"
loft run --format csv -o "$odd" "$deck"
[ "$status" = 0 ] && cmp -s "$odd" want
ok $? 'the name of a result may have blanks and quotes'
echo old > modest && chmod 640 modest
loft run --format csv -o modest "$deck"
[ "$status" = 0 ] && cmp -s modest want && [ "$(ls -l modest | cut -c1-10)" = '-rw-r-----' ]
ok $? 'a file that is replaced keeps its permissions' "$(ls -l modest)"
mkdir far && echo old > far/real && ln -s far/real near && ln -s near nearer
loft run --format csv -o nearer missing.crd
[ "$status" = 2 ] && [ "$(cat far/real)" = old ]
ok $? 'a run that failed keeps the file that a link leads to'
loft run --format csv -o nearer "$deck"
[ "$status" = 0 ] && [ -L nearer ] && [ -L near ] && cmp -s far/real want
ok $? 'links to links are written through'
loft run --format csv -o 'blank ' "$deck"
[ "$status" = 0 ] && cmp -s 'blank ' want && [ ! -e blank ]
ok $? 'a blank at the end of a name belongs to it'
loft plot "$deck" -o 'a; touch pwned "$(touch pwned)" `touch pwned`'
[ ! -e pwned ]
ok $? 'the name of a folder is no command'
tidy 'a run'

# --- what can't be written
echo old > kept
loft run --format csv -o /dev/full "$deck";            failed '/dev/full: No space left on device' 'a full device'
"$LOFT" run --format csv "$deck" > /dev/full 2> err;   status=$?
failed 'standard output: No space left on device' 'standard output on a full device'
"$LOFT" help > /dev/full 2> err;                       status=$?
failed 'No space left on device' 'help on a full device'
"$LOFT" run --format csv "$deck" >&- 2> err;           status=$?
failed 'Bad file descriptor' 'standard output closed'
"$LOFT" run --format csv -o unseen "$deck" >&- 2> err; status=$?
[ "$status" = 0 ] && cmp -s unseen want
ok $? 'with -o a closed standard output does not matter' "status $status, $(cat err)"
for closed in '2>&- <&- >&-' '2>&- <&-' '2>&-'; do
    rm -f alone
    eval '"$LOFT" run --format csv -o alone "$ROOT/cards/faults.crd"' "$closed"
    status=$?
    "$LOFT" run --format csv "$ROOT/cards/faults.crd" 2> /dev/null | cmp -s - alone && [ "$status" = 1 ]
    ok $? "with $closed no diagnostic gets into the result" "status $status, $(grep -v '^[0-9]' alone)"
done
loft run -o none/new "$deck";                          failed 'none/new: No such file or directory' 'a folder that is not there'
mkdir folder
loft run -o folder "$deck";                            failed 'folder: Is a directory' 'a folder in place of a result'
loft run -o kept missing.crd;                          failed 'missing.crd: No such file or directory' 'a deck that is not there'
loft run -o kept folder;                               failed 'folder: Is a directory' 'a folder in place of a deck'
[ "$(cat kept)" = old ]
ok $? 'a run that failed keeps the old file' "$(cat kept)"
loft check folder;                                     failed 'folder: Is a directory' 'check of a folder'
loft run ''; [ "$status" = 2 ] && [ -s err ]
ok $? 'a deck without a name' "status $status, $(cat err)"
loft run "$(printf '%05000d' 0)";                      failed 'File name too long' 'a name that is too long'
tidy 'a failed run'

# What root may do everyone may not: try as nobody where that can be done.
as_nobody=
if [ "$(id -u)" = 0 ]; then
    as_nobody='setpriv --reuid=65534 --regid=65534 --clear-groups'
    cp "$LOFT" ./loft-for-all && chmod 755 loft-for-all
    $as_nobody ./loft-for-all --version > /dev/null 2>&1 || as_nobody=none
fi
program=$LOFT; [ -z "$as_nobody" ] || program=$work/loft-for-all
if [ "$as_nobody" = none ]; then
    ok 0 'a deck without permission # SKIP run as root, and no setpriv to be someone else'
    ok 0 'a folder without permission # SKIP run as root, and no setpriv to be someone else'
else
    cp "$deck" secret.crd && chmod 000 secret.crd
    $as_nobody "$program" run secret.crd > out 2> err; status=$?
    failed 'secret.crd: Permission denied' 'a deck without permission'
    cp "$deck" open.crd && chmod 644 open.crd && mkdir shut && echo old > shut/result && chmod 644 shut/result && chmod 555 shut
    $as_nobody "$program" run -o shut/result open.crd > out 2> err; status=$?
    failed 'shut/result: Permission denied' 'a folder without permission'
    [ "$(cat shut/result)" = old ]
    ok $? 'a folder without permission keeps the old file'
fi

# --- signals, while the deck still arrives
mkfifo slow
# Starts a run that waits for its second card, sends it a signal and keeps its status.
stopped_by() {
    signal=$1
    # In a script's background SIGINT is ignored; perl gives it back.
    perl -e '$SIG{INT} = $SIG{TERM} = $SIG{HUP} = "DEFAULT"; exec @ARGV' \
        "$LOFT" run --format csv -o kept slow > out 2> err &
    run=$!
    exec 3> slow
    head -n 12 "$deck" >&3
    waited=0
    while [ -z "$(find . -name 'kept.part*')" ] && [ $waited -lt 100 ]; do sleep 0.05; waited=$((waited + 1)); done
    [ -n "$(find . -name 'kept.part*')" ]
    ok $? 'the unfinished result has a name of its own' "$(ls)"
    kill -"$signal" $run
    wait $run 2> /dev/null
    status=$?
    exec 3>&-
}
for pair in TERM:143 INT:130 HUP:129; do
    stopped_by "${pair%:*}"
    [ "$status" = "${pair#*:}" ]
    ok $? "SIG${pair%:*} ends LOFT by that signal" "status $status, $(cat err)"
    [ "$(cat kept)" = old ]
    ok $? "SIG${pair%:*} keeps the old file"
    tidy "SIG${pair%:*}"
done

sed 's/5\.0$/.001/' "$deck" > long.crd
{ "$LOFT" run --format csv long.crd 2> err; echo $? > ended; } | head -n 1 > out
[ "$(cat ended)" = 141 ] && [ "$(cat out)" = 'card,axis,x,y,slope,curvature' ] && [ ! -s err ]
ok $? 'SIGPIPE ends LOFT without a word' "status $(cat ended), $(cat err)"
finish
