#!/bin/sh
# loft plot on body decks: the pictures, what they are called, hostile names, decks with faults.

loft=${LOFT:?} root=${ROOT:?}
. "$root/tests/support/tap.sh"
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
LOFT_PLOT=$root/plot && export LOFT_PLOT
mkdir no-gnuplot
for tool in sh mkdir cat; do ln -s "$(command -v $tool)" "no-gnuplot/$tool"; done

# Runs loft plot, keeps output, messages and status.
plot() {
    "$loft" plot "$@" > "$work/out" 2> "$work/err" < /dev/null
    status=$?
}
seen() { echo "status $status"; head -n 20 "$work/out" "$work/err"; }

# The scripts of the pictures in a folder, without those that all share.
pictures() { (cd "$1" && ls | grep '\.gp$' | grep -vE '^(style|strokes|sheet|chart|space)\.gp$' | tr '\n' ' '); }

# --- data and scripts ---------------------------------------------------------------------------

(PATH=$work/no-gnuplot; plot "$root/cards/nose.crd"; echo "$status" > status); status=$(cat status)
[ "$status" = 2 ] && grep -q 'no gnuplot is found' err
ok $? 'without gnuplot: status 2' "$(seen)"
expected='area.gp combs.gp cut-01-station-0.gp cut-02-station-5.gp cut-03-station-10.gp
cut-04-station-15.gp cut-05-station-20.gp cut-06-station-25.gp cut-07-station-30.gp
cut-08-waterline-minus-16-floor.gp cut-09-buttock-4.5-frame.gp cut-10-oblique-oblique.gp lines.gp
view3d.gp '
[ "$(pictures nose-plots)" = "$(echo "$expected" | tr '\n' ' ' | sed 's/  *$/ /')" ]
ok $? 'a picture a cut, lines plan, combs, areas, view in space' "$(pictures nose-plots)"
whole=0
for script in nose-plots/*.gp; do
    case $script in */style.gp|*/strokes.gp|*/sheet.gp|*/chart.gp|*/space.gp) continue;; esac
    [ -s "${script%.gp}.dat" ] || whole=1
done
[ $whole = 0 ] && [ -z "$(find nose-plots -name '*.part*')" ]
ok $? 'each script has its data, nothing else is left' "$(ls -A nose-plots)"

# --- hostile and faulty decks -------------------------------------------------------------------

cat > evil.crd <<'CARDS'
TITLE   "; system('touch pwned'); "`touch pwned`@pwned'
LINE    A/../B  SIDE
STRAIGHT0.      0.      10.     .3
LINE    SH      SIDE    .5
LINE    SH      PLAN    1.5
LINE    TOP     SIDE    2.
LINE    TOP     PLAN    2.
SECTION S       A/../B  SH      TOP     0.      999.999
STATION 5.                      A/../X
END
CARDS
plot evil.crd -o evil
[ "$status" = 0 ] && [ -s evil/cut-01-station-5-a-..-x.dat ] && [ -z "$(find . -name pwned)" ]
ok $? 'no text of a deck is a command or a path' "$(seen; ls -A evil)"

printf 'LINE    A       SIDE\nSTRAIGHT0.      0.      X       1.\nEND\n' > bad.crd
plot bad.crd -o bad
[ "$status" = 1 ] && grep -q '^bad.crd:2:' err && [ ! -d bad ]
ok $? 'a deck without a sound section: faults, status 1, no folder' "$(seen)"

# --- drawn --------------------------------------------------------------------------------------

if ! command -v gnuplot > /dev/null; then
    echo '# no gnuplot on this machine: what it draws is not tested'
    finish
    exit
fi
for format in svg pdf png txt; do
    plot "$root/cards/nose.crd" -o nose --format $format
    missing=''
    for script in nose/*.gp; do
        case $script in */style.gp|*/strokes.gp|*/sheet.gp|*/chart.gp|*/space.gp) continue;; esac
        [ -s "${script%.gp}.$format" ] || missing="$missing $script"
    done
    [ "$status" = 0 ] && [ ! -s err ] && [ -z "$missing" ]
    ok $? "every picture is drawn as $format, without a complaint" "$missing $(seen)"
done
for text in 'NOSE OF SAE 700202' 'Lines plan, all views to one scale' 'LSH' 'WL -16'; do
    grep -qF "$text" nose/lines.svg; ok $? "the lines plan says $text"
done
grep -qF 'Cut 7: station 30' nose/cut-07-station-30.svg && grep -qF 'Girth' nose/area.svg &&
    grep -qF 'LCL side' nose/combs.svg
ok $? 'the other pictures say what they are' "$(ls nose)"
mv nose moved && rm moved/lines.* && plot "$root/cards/nose.crd" -o nose && mv nose/lines.gp nose/lines.dat moved/ &&
    (cd moved && gnuplot lines.gp > ../out 2> ../err)
[ -s moved/lines.svg ]
ok $? 'a folder can be moved and its pictures drawn again' "$(ls moved)"
finish
