#!/bin/sh
# Copies a step's files to a folder that is new or empty, with a Makefile that
# builds them there. Run in the tree's top.
# usage: standalone.sh DIR PROGRAM FILE...
set -eu
export LC_ALL=C
folder=$1
program=$2
shift 2

# A message is one line, whatever is in the folder's name.
refuse() {
    printf '%s %s\n' "$(printf '%s' "$folder" | tr '[:cntrl:]' '?')" "$1" >&2
    exit 2
}

# quoted TEXT: as one word for a shell.
quoted() {
    case $1 in
    *[!A-Za-z0-9./_-]*)
        printf "'"
        printf '%s' "$1" | sed "s/'/'\\\\''/g"
        printf "'"
        ;;
    *) printf '%s' "$1" ;;
    esac
}

case $folder in -*) folder=./$folder ;; esac
# A copy in step4_mine would be taken for a step, one in tests/ for tests, and
# make clean removes what is in build/ and out/.
case $(realpath -m "$folder")/ in
"$(pwd -P)"/step* | "$(pwd -P)"/tests/* | "$(pwd -P)"/.* | \
    "$(pwd -P)"/build/* | "$(pwd -P)"/out/*)
    refuse "is a name that the tree needs: name another folder"
    ;;
esac
if [ -d "$folder" ]; then
    files=$(ls -Aq "$folder")
    [ -z "$files" ] ||
        refuse "holds files, maybe somebody's work: name a new or empty folder"
elif [ -e "$folder" ] || [ -L "$folder" ]; then
    refuse "is no folder: name a new or empty one"
fi

mkdir -p "$folder"
for file in "$@"; do
    cp --parents "$file" "${file%%/*}/Makefile" "$folder"
done
printf 'ROOT := .\ninclude %s/Makefile\n' "$program" >"$folder/Makefile"
echo '# build it and draw with it:'
printf 'make -C %s\n%s --output mine.png\n' "$(quoted "${folder%/}")" \
    "$(quoted "${folder%/}/build/$program")"
