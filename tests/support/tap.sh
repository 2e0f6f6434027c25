# A tally of checks in the Test Anything Protocol for tests in shell.
#     . tests/support/tap.sh
#     [ "$a" = "$b" ]; ok $? 'a is b' "a is $a"
#     finish

checks=0 failures=0

# Counts a check: STATUS (0: passed), its name as a phrase, what to show where it failed.
ok() {
    checks=$((checks + 1))
    if [ "$1" = 0 ]; then echo "ok $checks - $2"; return; fi
    failures=$((failures + 1))
    echo "not ok $checks - $2"
    [ -z "${3:-}" ] || echo "$3" | sed 's/^/# /'
}

# Prints the plan; status 1 where any check failed or none was run.
finish() {
    echo "1..$checks"
    [ "$failures" = 0 ] && [ "$checks" -gt 0 ]
}
