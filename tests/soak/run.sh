#!/usr/bin/env bash
# Soak: a thousand bodies over a million frames, or as many as are given; see soak.cpp.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
${CXX:-g++} -std=c++17 -O2 -ffp-contract=off -fno-math-errno -I"$root/include" -pthread "$root"/src/*.cpp \
    "$root"/tests/golden/{scene,bodies,vehicles}.cpp "$root"/tests/soak/soak.cpp -o "$work/soak"
"$work/soak" "$@"
