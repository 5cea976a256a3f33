#!/bin/sh
# Installs the Debian packages that are missing.
# usage: set-up.sh yes|no PURPOSE PACKAGE:KIND:NAME...
# A package is there if NAME is: a command, a pkg-config module or a header
# (KIND command, module, header). With "no" nothing is installed: a missing
# package is named, and the exit status is 1.
set -eu
export LC_ALL=C # apt's words are read below
install=$1
purpose=$2
shift 2

fail() {
    echo "set-up: $*" >&2
    exit 1
}

missing=
for entry; do
    package=${entry%%:*}
    name=${entry##*:}
    kind=${entry#*:}
    # shellcheck disable=SC2086 # a header may be a pattern
    case ${kind%%:*} in
    command) command -v "$name" >/dev/null && continue ;;
    module) pkg-config --exists "$name" 2>/dev/null && continue ;;
    header) ls -d $name >/dev/null 2>&1 && continue ;;
    esac
    missing="$missing $package"
done
[ -n "$missing" ] || exit 0

command="apt-get install -y --no-install-recommends$missing"
[ "$install" = yes ] ||
    fail "packages are missing for $purpose; as root: $command"
command -v apt-get >/dev/null ||
    fail "packages are missing for $purpose, and there is no apt-get to" \
        "install them; these are Debian's names:$missing"
as_root=
if [ "$(id -u)" != 0 ]; then
    as_root=sudo
    sudo -p "%u's password, to install packages for $purpose: " -v \
        2>/dev/null ||
        fail "packages are missing for $purpose, and you cannot use sudo;" \
            "as root: $command"
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
cannot_download() {
    fail "apt-get cannot download packages for $purpose, is there a" \
        "network? It says: $(grep -m 1 '^[EW]: ' "$log")"
}

# A repository that has nothing to do with this may fail: what counts is
# whether the packages are known afterwards. But then no package is asked for
# again and again.
updated=yes
retries=3
$as_root apt-get update -qq -o APT::Update::Error-Mode=any >"$log" 2>&1 || {
    updated=no
    retries=0
}
unknown=
for package in $missing; do
    apt-cache show "$package" >/dev/null 2>&1 || unknown="$unknown $package"
done
case $updated$unknown in
no?*) cannot_download ;;
*libosmesa6-dev*)
    fail "this system has no OSMesa (libosmesa6-dev), which draws the" \
        "pictures: Mesa dropped it in 25.1; use Debian 12 or 13, for" \
        "example in a container"
    ;;
yes?*) fail "this system has no package$unknown, needed for $purpose" ;;
esac

# A line for each file: its address, name, size and hash.
# shellcheck disable=SC2086 # a list of words
cost=$(apt-get install -qq --no-install-recommends --print-uris $missing |
    awk '{ bytes += $(NF - 1) }
        END { printf "%d packages, %.0f MB to download, about %d min", NR,
            bytes / 1e6, 1 + bytes / 1e8 }')
echo "set-up: for $purpose: $cost; running: ${as_root:+sudo }$command"
# sudo keeps no variable.
# shellcheck disable=SC2086 # a list of words
$as_root env DEBIAN_FRONTEND=noninteractive $command \
    -o Acquire::Retries=$retries >"$log" 2>&1 || {
    ! grep -q '^E: Failed to fetch' "$log" || cannot_download
    cat "$log" >&2
    fail "apt-get could not install packages for $purpose: its log is above"
}
