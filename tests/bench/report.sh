#!/bin/sh
# Writes doc/performance.md to standard output: the machine, the compiler, how times are taken, and
# what each program of tests/bench prints.
#     report.sh PROGRAM...
# FC, FFLAGS: the compiler and its flags; LOFT, BENCH (where data for pictures go) and JUDGES are
# for the programs.

processor=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2> /dev/null | head -n 1)
[ -n "$processor" ] || processor=$(sysctl -n machdep.cpu.brand_string 2> /dev/null)
family=$(sed -n 's/^cpu family[^:]*: //p' /proc/cpuinfo 2> /dev/null | head -n 1)
model=$(sed -n 's/^model[[:space:]]*: //p' /proc/cpuinfo 2> /dev/null | head -n 1)
memory=$(sed -n 's/^MemTotal: *\([0-9]*\) kB/\1/p' /proc/meminfo 2> /dev/null)

cat << END
# Performance

Measured by \`make bench\`, which writes this page and its pictures. The figures of its tables are those of one run.

| | |
|---|---|
| processor | ${processor:-unknown}${family:+, family $family, model $model} |
| cores | $(getconf _NPROCESSORS_ONLN) |
| memory | ${memory:+$((memory/1048576)) GiB} |
| system | $(uname -s) $(uname -m) |
| compiler | $("${FC:-gfortran}" --version | head -n 1) |
| flags | \`$FFLAGS\` |

Times are of the wall clock where it is not said otherwise. A ratio is of two times taken in the same run, one after the other in turn, and the
best of five of each side, or the median ratio, counts: other work on the machine can only
lengthen a time. What is measured on one core says so.
END

for program in "$@"; do
    echo
    echo "bench: $program" >&2
    "$program" || exit 1
done
