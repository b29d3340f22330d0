#!/usr/bin/env bash
# The documentation site: build.sh FOLDER. Pages, the C++ reference (Doxygen), the search; every
# link inside the site is checked, and that nothing is fetched from another machine.
set -euo pipefail
cd "$(dirname "$0")/../.."
folder=$1
python=$(VASOROD_PYTHON=/usr/bin/python3 meshes/find_python.sh yaml mkdocs)
staging=build-docs
mkdir -p "$staging" "$(dirname "$folder")"
"$python" docs/site/stage.py "$staging"
{
  cat docs/Doxyfile
  echo "INPUT = hybrid/include"
  echo "USE_MDFILE_AS_MAINPAGE ="
  echo "PROJECT_NUMBER = $(packaging/version.sh)"
  echo "OUTPUT_DIRECTORY = $staging/pages/api"
  echo "HTML_OUTPUT = cpp"
} >"$staging/Doxyfile"
doxygen "$staging/Doxyfile" >"$staging/doxygen.log" 2>&1 ||
  { cat "$staging/doxygen.log" >&2; exit 1; }
"$python" -m mkdocs build --strict -f "$staging/mkdocs.yml" -d "$PWD/$folder"
"$python" docs/site/check_links.py "$folder"
echo "run: $folder/index.html; its search needs a server:"
echo "run: python3 -m http.server --directory $folder, then http://localhost:8000"
