#!/bin/sh
# Prints the path of a Python 3 that has the modules named as arguments (by default those that the
# generators need); exit 1 where there is none. The first `python3` in PATH may not be Debian's,
# which has the packaged modules. VASOROD_PYTHON overrides.
[ $# -gt 0 ] || set -- gmsh meshio numpy scipy
modules=$(echo "$@" | tr ' ' ',')
for candidate in "$VASOROD_PYTHON" python3 /usr/bin/python3; do
  if [ -n "$candidate" ] && "$candidate" -c "import $modules" 2>/dev/null; then
    command -v "$candidate"
    exit 0
  fi
done
echo "find_python.sh: no python3 with $modules (Debian packages them as python3-NAME)" >&2
exit 1
