#!/usr/bin/env bash
# Makes a Debian machine ready: installs the packages that are missing, and sketchkit into .venv.
#
#   bash install.sh          to run sketches
#   bash install.sh --dev    to run the tests as well
#
# It may be called again at any time: when nothing is missing it is done at once.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

packages=(
    python3-venv
    libegl1 libgl1 libgl1-mesa-dri                       # OpenGL, also without a graphics card
    libx11-6 libxcursor1 libxi6 libxinerama1 libxrandr2  # windows
    bubblewrap                                           # the wall around what is graded
)
spare=(libosmesa6) # OpenGL where EGL fails; Debian 13 no longer has it
extras="[grade,pde]"
if [ "${1:-}" = --dev ]; then
    packages+=(xvfb xauth xdotool chromium) # a display, a hand and a browser, for the tests of windows and pages
    extras="[dev]"
fi

main() {
    if command -v apt-get >/dev/null; then
        install_packages
    else
        echo "install.sh: no apt-get here; going on with what there is" >&2
    fi
    install_sketchkit
}

install_packages() {
    local missing=() package
    for package in "${packages[@]}"; do
        is_installed "$package" || missing+=("$package")
    done
    if [ ${#missing[@]} -gt 0 ]; then
        as_root apt-get update -qq
    fi
    for package in "${spare[@]}"; do
        if ! is_installed "$package" && apt-cache show "$package" >/dev/null 2>&1; then
            missing+=("$package")
        fi
    done
    if [ ${#missing[@]} -gt 0 ]; then
        as_root env DEBIAN_FRONTEND=noninteractive \
            apt-get install -y -qq --no-install-recommends "${missing[@]}" </dev/null >/dev/null
    fi
}

# Installs this checkout itself, so that a change of its files needs no second call.
install_sketchkit() {
    local wanted
    wanted="$extras $(cksum <pyproject.toml)"
    if [ "$(cat .venv/installed 2>/dev/null)" = "$wanted" ] && .venv/bin/python -c "" 2>/dev/null; then
        return
    fi
    "$(find_python)" -m venv --clear .venv
    .venv/bin/python -m pip install --quiet --disable-pip-version-check --editable ".$extras"
    echo "$wanted" >.venv/installed
}

find_python() {
    local candidate
    for candidate in python3 python3.14 python3.13 python3.12 python3.11 /usr/bin/python3; do
        if "$candidate" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
            echo "$candidate"
            return
        fi
    done
    echo "install.sh: Python 3.11 or newer is needed" >&2
    return 1
}

is_installed() {
    [ "$(dpkg-query --show --showformat '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

as_root() {
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

main
