#!/usr/bin/env bash
# ./run check: layout of C++ and Python, line lengths, clang-tidy. One line per check; the first
# that finds something lists it and ends with 1.
#   cmake/check.sh BUILD [--since REF | --all]
# BUILD has compile_commands.json. clang-tidy takes 10 to 20 s of processor time a file, so it reads
# the rooms of `usual` only; --since REF: the files changed since REF; --all: every file.
set -euo pipefail
cd "$(dirname "$0")/.."
export LC_ALL=C.UTF-8
usual='^hybrid/(data|judge)/'
width=100

build=$1
shift
scope=usual
since=
while [ $# -gt 0 ]; do
  case "$1" in
    --all) scope=all ;;
    --since)
      scope=since
      since=${2:-}
      git rev-parse --verify --quiet "$since^{commit}" >/dev/null ||
        { echo "check: --since: found '$since', expected a commit" >&2; exit 2; }
      shift
      ;;
    *) echo "check: $1: found no such option, expected --all or --since REF" >&2; exit 2 ;;
  esac
  shift
done

[ -f "$build/compile_commands.json" ] ||
  { echo "check: $build: found no compile_commands.json, expected a configured build" >&2; exit 2; }

# The tree's files whose names match the extended regular expression.
files() {
  {
    git ls-files --cached --others --exclude-standard 2>/dev/null ||
      find . -type f -not -path './build*' -not -path './results*' -not -path './.git/*' |
      sed 's|^\./||'
  } | grep -E "$1" | while read -r name; do [ ! -f "$name" ] || echo "$name"; done
}

findings=$(mktemp)
trap 'rm -f "$findings"' EXIT

# Runs a command whose output is what it found; says how it went.
check() {
  local name=$1 start=$SECONDS
  shift
  if "$@" >"$findings" 2>&1; then
    echo "check: $name: good ($((SECONDS - start)) s)"
  else
    cat "$findings"
    echo "check: $name: the findings are above"
    exit 1
  fi
}

format() { files '\.(h|cpp)$' | xargs clang-format --dry-run -Werror; }
layout() { files '\.py$' | xargs black --check; }
style() { files '\.py$' | xargs flake8; }

# Not tables, lines with a URL, fenced code, nor pages that ./run report writes.
prose() {
  files '\.md$' | xargs grep -L 'Written by `./run report`' |
    LC_ALL=C xargs awk -v width=$width '
      FNR == 1 { fenced = 0 }
      /^ *```/ { fenced = !fenced; next }
      fenced || /^ *\|/ || /https?:/ { next }
      { line = $0; gsub(/[\200-\277]/, "", line) }  # a letter may have several bytes
      length(line) > width { print FILENAME ":" FNR ": " length(line) " columns"; found = 1 }
      END { exit found }'
}

lines() {
  ! { files '(CMakeLists\.txt|\.cmake|\.sh|Snakefile)$'; files '^(run|\.ci/run)$'; } |
    xargs grep -nHE "^.{$((width + 1)),}"
}

# The compilation units to read, of those that BUILD compiles.
units() {
  {
    case "$scope" in
      all) files '\.cpp$' ;;
      usual) files "$usual.*\.cpp$" ;;
      since) # a header stands for the source file of its name
        git diff --name-only --diff-filter=d "$since" -- '*.h' '*.cpp' |
          sed 's/\.h$/.cpp/' | sort -u
        ;;
    esac
  } | while read -r unit; do
    ! grep -q "\"file\": \"$PWD/$unit\"" "$build/compile_commands.json" || echo "$unit"
  done
}

tidy() {
  # shellcheck disable=SC2086 # no name of ours has a space
  printf '%s\n' $1 | xargs -r -P "$(nproc)" -n 1 \
    clang-tidy --quiet --warnings-as-errors='*' -p "$build" \
    --extra-arg=-Wno-unused-command-line-argument # of GCC's own options
}

check "clang-format" format
check "black" layout
check "flake8" style
check "Markdown's lines" prose
check "lines of CMake and shell" lines
chosen=$(units)
count=$(wc -w <<<"$chosen")
check "clang-tidy, $count files ($scope)" tidy "$chosen"
