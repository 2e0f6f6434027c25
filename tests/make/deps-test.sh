#!/bin/sh
# Installs the outside judges of exported files into a virtual environment of Python's: the CAD
# kernel OpenCASCADE, ezdxf and trimesh, with versions as tests/judges/requirements.txt has them.
#     deps-test.sh FOLDER
# Python's venv and what renders PDF and SVG come by apt-get, as root or, with DEPS=yes, through
# sudo; otherwise the line to type is printed and the status is 1. Where nothing is missing it says
# nothing and needs no network.

venv=${1:?the folder of the virtual environment}
wanted=tests/judges/requirements.txt
apt='apt-get install -y --no-install-recommends python3 python3-venv poppler-utils librsvg2-bin'

has() { command -v "$1" > /dev/null 2>&1; }

missing=
has python3 && python3 -c 'import venv, ensurepip' 2> /dev/null || missing="$missing python3-venv"
has pdftoppm || missing="$missing poppler-utils"
has rsvg-convert || missing="$missing librsvg2-bin"
if [ -n "$missing" ]; then
    echo "The judges need, and this machine lacks:$missing" >&2
    sudo=sudo
    [ "$(id -u)" = 0 ] && sudo=
    if has apt-get && { [ -z "$sudo" ] || { [ "${DEPS:-}" = yes ] && has sudo; }; }; then
        $sudo apt-get update -q && $sudo env DEBIAN_FRONTEND=noninteractive $apt || exit 1
    else
        echo "Install it, then ask make again; on Debian and Ubuntu:" >&2
        echo "    ${sudo:+sudo }apt-get update && ${sudo:+sudo }$apt" >&2
        exit 1
    fi
fi

cmp -s "$wanted" "$venv/requirements.txt" && exit 0
echo "judges: into $venv"
[ -x "$venv/bin/python" ] || python3 -m venv "$venv" || exit 1
"$venv/bin/python" -m pip install --quiet --requirement "$wanted" || exit 1
cp "$wanted" "$venv/requirements.txt"
