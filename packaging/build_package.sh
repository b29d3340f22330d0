#!/usr/bin/env bash
# The Debian packages of the tree as it stands, committed or not:
#   build_package.sh FOLDER JOBS [OPTION ...]   options of dpkg-buildpackage
# FOLDER/vasorod-VERSION is the copied source with its objects, which a second build uses again if
# there is a ccache; FOLDER/*.deb are the packages. Lintian reads them all, the planner is tried.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1 jobs=$2
shift 2
version=$(packaging/version.sh)
source=$folder/vasorod-$version
rm -rf "$source" "$folder"/*.deb "$folder"/*.changes "$folder"/*.buildinfo
mkdir -p "$source"
{
  git ls-files --cached --others --exclude-standard 2>/dev/null ||
    find . -type f -not -path './build*' -not -path './results*' -not -path './.git/*'
} | while read -r file; do [ ! -f "$file" ] || echo "$file"; done |
  tar -c -T - | tar -x -C "$source"
if [ -z "${CMAKE_CXX_COMPILER_LAUNCHER:-}" ] && [ -d /usr/lib/ccache ]; then
  export PATH=/usr/lib/ccache:$PATH
fi
echo "run: building packages in $source (its log: $folder/log)"
export DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:+$DEB_BUILD_OPTIONS }parallel=$jobs noautodbgsym"
(cd "$source" && dpkg-buildpackage -b -us -uc "$@") >"$folder/log" 2>&1 ||
  { tail -30 "$folder/log" >&2; exit 1; }
ls "$folder"/*.deb
lintian --fail-on error,warning "$folder"/*.changes
echo "run: lintian has no errors and no warnings"
# The planner as its user gets it, with the scenes of the package vasorod.
if ls "$folder"/vasorod-plan_*.deb >/dev/null 2>&1; then
  root=$folder/unpacked
  rm -rf "$root"
  for package in vasorod vasorod-plan; do dpkg-deb -x "$folder/${package}_"*.deb "$root"; done
  packaging/try_planner.py "$root/usr/bin/vasorod-plan" \
    "$root/usr/share/vasorod/benchmarks/cases/glenn/infant.yaml"
fi
