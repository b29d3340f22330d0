#!/usr/bin/env bash
# Writes the licences of the npm packages in the page of vasorod-plan:
#   page_licences.sh APP_JS FILE
# The page's build puts a title (NAME VERSION, LICENCE) and a text of each package at the head of
# APP_JS. Of a package without a licence file the text is licences/NAME.txt beside this script, with
# _ for / in NAME. A package without any text is an error: all ask that it is handed on.
set -euo pipefail
app=$1
file=$2
folder=$(dirname "$(realpath "$0")")/licences
unfinished=$(mktemp "$file.XXXXXX")
trap 'rm -f "$unfinished"' EXIT

[ "$(head -1 "$app")" = '/*!' ] ||
  { echo "page_licences.sh: $app: found no licences at its head, expected /*!" >&2; exit 1; }
awk -v folder="$folder" '
  # The text of the package before this line, where it had none.
  function finish(  line, found, name) {
    if (title == "" || texts > 0) return
    name = title
    sub(/ [^ ]+, .*/, "", name)
    gsub("/", "_", name)
    while ((getline line < (folder "/" name ".txt")) > 0) {
      print line
      found = 1
    }
    if (!found) {
      print "page_licences.sh: found no licence text of " title > "/dev/stderr"
      failed = 1
      exit
    }
    print ""
  }
  NR == 1 { next }
  NR == 2 { print "The page of vasorod-plan contains these packages of npm."; next }
  /^\*\/$/ { finish(); exit }
  /^----$/ { finish(); title = ""; texts = 0; print; next }
  title == "" && NF { title = $0; print; next }
  { if (NF) ++texts; print }
  END { exit failed }' "$app" >"$unfinished"
chmod 644 "$unfinished"
mv "$unfinished" "$file"
