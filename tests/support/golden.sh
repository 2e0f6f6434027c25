# What each golden file holds. golden/NAME.KIND is what LOFT prints for cards/NAME.crd; the kinds are
# the cases below. A file of that name is all it takes: `touch golden/NAME.csv && make golden`.

# Lists the golden files.
golden_files() { find golden -maxdepth 1 \( -name '*.lst' -o -name '*.csv' -o -name '*.check' \) | sort; }

# Prints what a golden file should hold: golden_output golden/NAME.KIND. Ends with LOFT's status.
golden_output() {
    name=$(basename "$1")
    deck=cards/${name%%.*}.crd
    case ${name#*.} in
    s360.lst) "$LOFT" run --arithmetic s360 "$deck" 2> /dev/null ;;
    ieee.lst) "$LOFT" run --arithmetic ieee "$deck" 2> /dev/null > "$new.all"
              status=$?
              without_lapack "$new.all"; rm -f "$new.all"
              return "$status" ;;
    rows.csv) "$LOFT" sweep "$deck" 2> /dev/null ;;
    csv)      "$LOFT" run --format csv "$deck" 2> /dev/null ;;
    check)    "$LOFT" check "$deck" 2>&1 ;;
    audit.lst) "$LOFT" audit "$deck" 2> /dev/null ;;
    audit.csv) "$LOFT" audit --format csv "$deck" 2> /dev/null ;;
    *)        echo "$1: no such kind of golden file" >&2; return 2 ;;
    esac
}

# Leaves out the figures of the five equations: their last digits are those of the LAPACK at hand.
without_lapack() {
    awk '/^$/ { skipping = 0 } !skipping; /^THE SAME FROM FIVE EQUATIONS/ { skipping = 1 }' "$1"
}
