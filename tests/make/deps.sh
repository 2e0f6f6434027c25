#!/bin/sh
# Installs what LOFT needs and this machine lacks: gfortran, LAPACK, gnuplot and perl's `prove`.
# Installs by apt-get alone, as root or, with DEPS=yes, through sudo. Otherwise it prints the line
# to type and stops with status 1. Where nothing is missing it says nothing and needs no network.
# With MPI=1 OpenMPI is needed, too.

apt='apt-get install -y --no-install-recommends gfortran libc6-dev liblapack-dev gnuplot-nox perl'
dnf='dnf install -y gcc-gfortran lapack-devel blas-devel gnuplot perl-Test-Harness'
pacman='pacman -S --needed gcc-fortran lapack blas gnuplot perl'
brew='brew install gcc lapack gnuplot perl'

if [ -n "${MPI:-}" ]; then
    apt="$apt libopenmpi-dev openmpi-bin"
    dnf="$dnf openmpi-devel"
    pacman="$pacman openmpi"
    brew="$brew open-mpi"
fi

has() { command -v "$1" > /dev/null 2>&1; }

# True where a program that calls LAPACK can be linked.
links_lapack() {
    folder=$(mktemp -d) || return 1
    printf 'external dgesv\ncall dgesv()\nend\n' > "$folder/try.f90"
    has brew && from="-L$(brew --prefix lapack 2> /dev/null)/lib"
    "${FC:-gfortran}" "$folder/try.f90" ${from:-} -llapack -lblas -o "$folder/try" 2> /dev/null
    status=$?
    rm -rf "$folder"
    return $status
}

missing=
has "${FC:-gfortran}" || missing="$missing gfortran"
links_lapack          || missing="$missing lapack"
has gnuplot           || missing="$missing gnuplot"
has prove             || missing="$missing prove"
[ -z "${MPI:-}" ] || has mpifort || missing="$missing mpifort"
[ -z "${MPI:-}" ] || has mpirun  || missing="$missing mpirun"
[ -z "$missing" ] && exit 0
echo "LOFT needs, and this machine lacks:$missing" >&2

sudo=sudo
[ "$(id -u)" = 0 ] && sudo=
if has apt-get && { [ -z "$sudo" ] || { [ "${DEPS:-}" = yes ] && has sudo; }; }; then
    $sudo apt-get update -q
    exec $sudo env DEBIAN_FRONTEND=noninteractive $apt
fi

echo 'Install it with this line, then ask make again:' >&2
if   has apt-get; then echo "    ${sudo:+sudo }apt-get update && ${sudo:+sudo }$apt"
elif has dnf;     then echo "    ${sudo:+sudo }$dnf"
elif has pacman;  then echo "    ${sudo:+sudo }$pacman"
elif has brew;    then echo "    $brew"
else
    echo "    Debian, Ubuntu:  sudo apt-get update && sudo $apt"
    echo "    Fedora:          sudo $dnf"
    echo "    Arch:            sudo $pacman"
    echo "    macOS, Homebrew: $brew"
fi >&2
exit 1
