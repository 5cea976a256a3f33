#!/bin/sh
# Installs the Debian packages that are missing.
# usage: set-up.sh yes|no PURPOSE PACKAGE:KIND:NAME...
# A package is there if NAME is: a command, a pkg-config module or a header
# (KIND command, module, header). With "no" nothing is installed: a missing
# package is named, and the exit status is 1.
set -eu
export LC_ALL=C
install=$1
purpose=$2
shift 2

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

if [ "$install" = no ]; then
    echo "missing for $purpose:$missing (DEPS=no: not installed)" >&2
    exit 1
fi
as_root=
[ "$(id -u)" = 0 ] || as_root=sudo
command="$as_root apt-get install -y --no-install-recommends$missing"
echo "set-up: $purpose need$missing; running: ${command# }"
$as_root apt-get update -qq
DEBIAN_FRONTEND=noninteractive $command >/dev/null
