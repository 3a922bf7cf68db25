#!/usr/bin/env bash
# Fuzzes each target for so many seconds (30 by default) from the committed corpus, with the address and
# undefined-behaviour sanitizers. Needs clang++ with its runtime (Debian: libclang-rt-dev). What fails is left in the
# build folder, as crash-*; to run it again: <target> crash-…
#
#     tests/fuzz/run.sh [seconds] [build folder]
set -euo pipefail
seconds=${1:-30}
root=$(cd "$(dirname "$0")/../.." && pwd)
work=${2:-$(mktemp -d)}
[ $# -ge 2 ] || trap 'rm -rf "$work"' EXIT
mkdir -p "$work"

flags=(-std=c++17 -O1 -g -ffp-contract=off -fno-omit-frame-pointer -I"$root/include" -I"$root/src"
    -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all)
export root work
compile() {
    clang++ "$@"
}
export -f compile
for source in "$root"/src/*.cpp; do
    printf '%s\0' "$source"
done | xargs -0 -P "${FUZZ_JOBS:-2}" -I{} bash -c 'source=$1; shift
    compile "$@" -c "$source" -o "$work/$(basename "$source").o"' _ {} "${flags[@]}"

for target in calls snapshots inertia precision; do
    clang++ "${flags[@]}" -fsanitize=fuzzer "$root/tests/fuzz/$target.cpp" "$work"/*.o -pthread -o "$work/$target"
    mkdir -p "$work/corpus/$target"
    echo "== $target, $seconds s"
    (cd "$work" && "./$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=1024 -max_len=600 -verbosity=0 \
        -print_final_stats=1 "corpus/$target" "$root/tests/fuzz/corpus/$target")
done
