#!/bin/sh
# Every command on small decks of every kind, in the build of the sanitizers: nothing is reported, and
# no memory is lost.
cd "${ROOT:?}" || exit 1
. tests/support/tap.sh
loft=${BUILD:-build}/sanitize/loft
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
export LOFT_PLOT="$PWD/plot" OMP_NUM_THREADS=2 ASAN_OPTIONS=detect_leaks=1:exitcode=99 UBSAN_OPTIONS=print_stacktrace=1

# Runs a command and looks at what the sanitizers say: clean COMMAND...
clean() {
    "$loft" "$@" > "$work/out" 2> "$work/err" < /dev/null
    status=$?
    [ $status -le 2 ] && ! grep -q 'Sanitizer\|runtime error' "$work/err"
    ok $? "$(echo "$*" | sed "s|$work/||")" "status $status, $(grep -A12 'Sanitizer\|runtime error\|leak of' "$work/err" | grep '#\|error' | head -12)"
}
for deck in tests/fuzz/seeds/*.crd tests/fuzz/found/*.crd cards/arcs.crd cards/blend.crd cards/c-bezier.crd \
    cards/cone.crd cards/duct.crd cards/faired.crd cards/faults.crd cards/hatch.crd cards/inlet.crd cards/nose-cap.crd \
    cards/patch.crd cards/round-nose.crd cards/sae700202.crd; do
    case $deck in *audit*) continue ;; esac
    clean run "$deck"
    clean run --format csv "$deck"
    clean check "$deck"
    for form in dxf step stl pdf; do clean export "$deck" -o "$work/x.$form"; done
    clean plot "$deck" -o "$work/plots"
    case $deck in *conic* | *closed* | *sae*) clean run --arithmetic s360 "$deck" ;; esac
    case $deck in *sweep* | *grid*) clean sweep "$deck"; clean sweep "$deck" -o "$work/rows" ;; esac
done
for deck in tests/fuzz/seeds/quarter.crd tests/fuzz/seeds/duct.crd cards/patch.crd cards/closed-forms.crd; do
    for form in svg igs obj nc hrm wgs csv; do clean export "$deck" -o "$work/x.$form"; done
    clean export "$deck" -o "$work/x.dxf" --dxf-splines
    clean export "$deck" -o "$work/x.dxf" --3d
    clean export "$deck" -o "$work/x.dxf" --arcs
    clean export "$deck" -o "$work/x.nc" --arcs
    clean export "$deck" -o "$work/x.svg" --bevel 1. --half
done
for deck in tests/fuzz/seeds/audit.crd tests/fuzz/seeds/audit.csv cards/audit-sae700202.crd; do
    for form in listing csv deck; do clean audit --format $form "$deck"; done
    clean check "$deck"
    clean plot "$deck" -o "$work/plots"
done

# The library in careless hands.
version=$("$loft" --version)
cc -std=c99 -g -fsanitize=address,undefined -Isrc/api tests/library/abuse.c "${BUILD:-build}/sanitize/libloft.a" \
    -lgfortran -lgomp -llapack -lblas -lm -o "$work/abuse" 2> "$work/err" &&
    (cd "$work" && ./abuse "$ROOT" "${version#loft }") > "$work/out" 2> "$work/err"
[ $? = 0 ] && ! grep -q 'Sanitizer\|runtime error' "$work/err"
ok $? "the library, called carelessly: $(grep -c '^ok' "$work/out") checks" "$(grep -v '^ok' "$work/out"; head -40 "$work/err")"
clean help
clean --version
clean run missing.crd
finish
