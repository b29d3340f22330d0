#!/bin/sh
# Prints the version, which stands in one place: project() of CMakeLists.txt.
sed -n 's/^project(vasorod VERSION \([0-9.]*\).*/\1/p' "$(dirname "$0")/../CMakeLists.txt"
