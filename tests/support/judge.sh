# Files judged by programs of others: what tests/judges/*.py say becomes checks of a test in shell.
#     . tests/support/judge.sh
#     judge 'the nose as STEP' step.py nose.step --unit 25.4
#     finish
# Where `make deps-test` has not been run the whole test is skipped.

. tests/support/tap.sh

if [ ! -x "${JUDGES:-}/bin/python" ]; then
    echo '1..0 # SKIP the judges are not installed: make deps-test'
    exit 0
fi

work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT

# Runs a judge and counts its checks: PHRASE SCRIPT ARGUMENTS...
judge() {
    phrase=$1 script=$2
    shift 2
    "$JUDGES/bin/python" "tests/judges/$script" "$@" > "$work/said" 2> "$work/trouble"
    status=$?
    before=$failures
    judged=0
    while IFS= read -r line; do
        case $line in
            'ok '*)     ok 0 "$phrase: ${line#ok * - }"; judged=$((judged + 1)) ;;
            'not ok '*) ok 1 "$phrase: ${line#not ok * - }"; judged=$((judged + 1)) ;;
            '# '*)      echo "$line" ;;
        esac
    done < "$work/said"
    if [ "$status" != 0 ] && [ "$failures" = "$before" ] || [ "$judged" = 0 ]; then
        ok 1 "$phrase: $script comes to a judgement" "status $status, $(tail -n 5 "$work/trouble")"
    fi
}

# Exports a deck: exported FILE DECK OPTIONS... ; the file is then in the working folder.
exported() {
    file=$1 deck=$2
    shift 2
    "${LOFT:?}" export "$deck" -o "$work/$file" "$@" > "$work/receipt" 2> "$work/trouble"
    status=$?
    [ "$status" = 0 ] || [ "$status" = 1 ]
    ok $? "$deck is exported as $file${*:+ $*}" "status $status, $(cat "$work/trouble")"
}

# Millimetres of the unit of a deck: millimetres DECK
millimetres() {
    case $(sed -n 's/^UNITS[ ,]*\([A-Z]*\).*/\1/p' "$1") in
        MM) echo 1 ;;
        FEET) echo 304.8 ;;
        *) echo 25.4 ;;
    esac
}

# A measure of a listing of loft run: measure 'WETTED AREA' FILE
measure() { sed -n "s/^$1  *\([0-9.]*\) .*/\1/p" "$2"; }
