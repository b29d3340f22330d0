#!/usr/bin/env bash
# Writes the manual pages of one built program and of each of its commands, from its own --help:
#   make_manual.sh PROGRAM FOLDER   FOLDER/NAME.1, FOLDER/NAME-COMMAND.1
# A new command has its page without a change here. PROGRAM.h2m beside this script has the sections
# that --help does not state. Needs help2man.
set -euo pipefail
program=$(realpath "$1")
folder=$2
here=$(dirname "$(realpath "$0")")
name=$(basename "$program")
mkdir -p "$folder"
version=$("$program" --version)
version=${version#"$name "}

scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT

# page NAME HELP-OPTION SHORT-DESCRIPTION SEE-ALSO
page() {
  # help2man calls a page after the program that it asks; CLI11 prints that program's whole path.
  cat >"$scratch/$1" <<TEXT
#!/bin/sh
"$program" "\$@" | sed "s|$program|$name|g"
TEXT
  chmod +x "$scratch/$1"
  printf '[see also]\n%s\n' "$4" >"$scratch/see_also.h2m"
  help2man --no-info --section 1 --manual 'Vasorod' --source "$name $version" \
    --version-string "$version" --help-option "$2" --name "$3" --include "$here/$name.h2m" \
    --include "$scratch/see_also.h2m" --output "$folder/$1.1" "$scratch/$1"
}

# The pages of this program but one, and the other programs', as man shows them.
others() {
  for other in "$name" $(commands | sed "s/\t.*//; s/^/$name-/") "${companions[@]}"; do
    [ "$other" = "$1" ] || printf '%s(1), ' "$other"
  done | sed 's/, $//'
}

# The commands and what they do, a line each: NAME<tab>TEXT.
commands() {
  "$program" --help | awk '
    /^[^ ]/ { inside = index($0, "Subcommands") == 1; next }
    inside && /^  [^ ]/ { name = $1; $1 = ""; sub(/^ /, ""); print name "\t" $0 }'
}

case "$name" in
  vasorod)
    companions=(vasorod-fem vasorod-plan)
    summary='predict how blood vessels deform when they are re-joined'
    ;;
  vasorod-plan)
    companions=(vasorod)
    summary='plan how blood vessels are re-joined, in the browser'
    ;;
  *)
    companions=(vasorod)
    summary='finite-element reference of vasorod'
    ;;
esac
page "$name" --help "$summary" "$(others "$name")"
while IFS=$'\t' read -r command text; do
  page "$name-$command" "$command --help" "${text,}" "$(others "$name-$command")"
done < <(commands)
