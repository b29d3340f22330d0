#!/bin/sh
# Prints the path of a Python 3 that has the modules the generators need (gmsh, meshio, numpy, scipy); exit 1 where there is none.
# The `python3` first in PATH may be another one than Debian's, which has the packaged modules. VASOROD_PYTHON overrides.
for candidate in "$VASOROD_PYTHON" python3 /usr/bin/python3; do
  if [ -n "$candidate" ] && "$candidate" -c 'import gmsh, meshio, numpy, scipy' 2>/dev/null; then
    command -v "$candidate"
    exit 0
  fi
done
echo "find_python.sh: no python3 with gmsh, meshio, numpy and scipy (Debian: apt-get install python3-gmsh python3-meshio python3-scipy)" >&2
exit 1
