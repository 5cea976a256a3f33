#!/bin/sh
# Every C file through both compilers with every warning an error; the shell
# scripts through theirs; and a lesson's length. Run by `make lint`, after the
# set-up.
set -eu
export LC_ALL=C # wc says "total"
set -- -I. -Ibuild/glad/include -fsyntax-only -Werror \
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion
packages=$(pkg-config --cflags-only-I osmesa cglm glfw3 |
    sed 's/-I/-isystem /g')
for compiler in gcc clang; do
    for file in $(git ls-files '*.c'); do
        # shellcheck disable=SC2086 # a list of words
        $compiler -std=c11 "$@" $packages "$file"
    done
done
# shellcheck disable=SC2046 # a list of names
shellcheck $(git ls-files '*.sh') .ci/run
for limit in 100:main.c 80:README.md; do
    wc -l step*/"${limit#*:}" | awk -v most="${limit%:*}" '$2 != "total" &&
        $1 > most { print $2 ": " $1 " lines, at most " most; long = 1 }
        END { exit long }' >&2
done
echo 'lint: nothing to report'
