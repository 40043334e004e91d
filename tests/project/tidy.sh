#!/usr/bin/env bash
# tidy.sh BUILD: clang-tidy over every source of the project that BUILD/compile_commands.json names, alone or in a file
# that includes several of them, as .clang-tidy says. What passed is passed over until a source of it, a header or the
# rules change.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=$1
passed=$build/tidy
mkdir -p "$passed"

common=$( (cat .clang-tidy && find . -path './build*' -prune -o -name '*.hpp' -print0 | sort -z | xargs -0 cat) |
  sha256sum)
export build passed common

# The text of a source, and of the sources that it includes by their whole names.
text_of() { cat "$1" && sed -n 's|^#include "\(/.*\.cpp\)"$|\1|p' "$1" | xargs -r cat; }

check() {
  local source=$1 stamp
  stamp=$passed/$( (printf '%s%s' "$common" "$source" && text_of "$source") | sha256sum | cut -c1-40)
  [[ ! -e $stamp ]] || return 0
  clang-tidy-16 -p "$build" --quiet "$source" 2> >(grep -v 'warnings\? generated' >&2) && touch "$stamp"
}
export -f check text_of

# shellcheck disable=SC2016
python3 -c 'import json, os, sys
print("\0".join(sorted({os.path.relpath(c["file"]) for c in json.load(open(sys.argv[1]))})), end="")' \
  "$build/compile_commands.json" | xargs -0 -n 1 -P "$(nproc)" bash -c 'check "$@"' check
