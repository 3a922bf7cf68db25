#!/bin/bash
# Cyclone as its users meet it: installed and found, with pkg-config, as a guest in their build, copied into
# their tree, on Windows, in a debugger. Every case builds a small game (falling.cpp), runs it, and it compares
# numbers.
#
#   tests/consumers/run.sh        (about two minutes; needs cmake, make, g++, clang++, pkg-config and mingw-w64;
#        what gdb shows is looked at where there is gdb, Windows programs run where there is wine)

set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
tree=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cases=0

# Runs a command silently, or says everything it said and ends.
quietly() {
    "$@" >"$work/log" 2>&1 && return
    cat "$work/log" >&2
    echo "failed: $*" >&2
    exit 1
}

# The last command must have said it.
says() {
    grep -q "$1" "$work/log" && return
    cat "$work/log" >&2
    echo "not said: $1" >&2
    exit 1
}

passed() {
    cases=$((cases + 1))
    echo "ok: $*"
}

run_game() { # DIRECTORY-OF-GAME
    quietly "$1/game"
    says 'falls as it should'
}

# Several files in one, which takes half the time; copied() builds them one by one.
build() { # SOURCE BUILD OPTIONS...
    quietly cmake -S "$1" -B "$2" -DCMAKE_UNITY_BUILD=ON "${@:3}"
    quietly cmake --build "$2" -j2
}

install_library() { # NAME OPTIONS...
    build "$tree" "$work/$1-build" -DCYCLONE_BUILD_TESTS=OFF -DCYCLONE_BUILD_DEMOS=OFF \
        -DCYCLONE_BUILD_BENCHMARK=OFF -DCMAKE_CXX_FLAGS=-Werror "${@:2}"
    quietly cmake --install "$work/$1-build" --prefix "$work/$1-first"
    mv "$work/$1-first" "$work/$1" # a prefix that is moved still works
}

package() { # NAME: with find_package
    build "$here/package" "$work/$1-game" -DCMAKE_PREFIX_PATH="$work/$1" -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror'
    run_game "$work/$1-game"
    passed "find_package, $1, from a moved prefix"
}

pkgconfig() { # NAME
    local lib=$work/$1/lib
    [[ -d $lib/pkgconfig ]] || lib=$(dirname "$(dirname "$(find "$work/$1" -name cyclone.pc)")")
    mkdir "$work/$1-pc"
    # shellcheck disable=SC2046  # several words
    quietly g++ -std=c++17 "$here/falling.cpp" -o "$work/$1-pc/game" \
        $(PKG_CONFIG_PATH=$lib/pkgconfig pkg-config --cflags --libs 'cyclone >= 0.1') -Wl,-rpath,"$lib"
    run_game "$work/$1-pc"
    passed "pkg-config, $1, from a moved prefix"
}

shared_lets_out_its_interface_only() {
    local library foreign
    library=$(find "$work/shared" -name 'libcyclone.so.*.*.*')
    foreign=$(nm -DC --defined-only "$library" | grep -vE ' (cyclone::|(vtable|typeinfo|typeinfo name) for cyclone::|std::)' |
        grep -v ' std::' || true)
    [[ -z $foreign ]] || { echo "lets out: $foreign" >&2; exit 1; }
    passed "shared, only the interface is let out, as $(objdump -p "$library" | sed -n 's/ *SONAME *//p')"
}

guest() { # NAME OPTIONS...
    build "$here/guest" "$work/$1-game" -DCYCLONE_TREE="$tree" "${@:2}"
    run_game "$work/$1-game"
    quietly cmake --install "$work/$1-game" --prefix "$work/$1-installed"
    [[ $(cd "$work/$1-installed" && find . -type f) == ./bin/game ]] || { find "$work/$1-installed" >&2; exit 1; }
    passed "$1: no targets, flags, cache entries or installed files but the library"
}

# include/ and src/*.{h,cpp} in a foreign tree, with an engine's flags.
copied() { # COMPILER STANDARD
    local tree_copy=$work/engine flags="-std=$2 -fno-exceptions -fno-rtti -Wall -Wextra -Wconversion -Wshadow -Werror"
    local objects=$work/engine/objects-$1-$2
    mkdir -p "$objects/headers"
    # shellcheck disable=SC2016  # expanded by the inner shell
    (cd "$tree_copy" && ls ./*.cpp) |
        quietly xargs -P2 -I{} sh -c "cd '$tree_copy' && $1 $flags -Iinclude -c {} -o '$objects'/\$(basename {}).o"
    quietly "$1" "$objects"/*.o -o "$objects/game" -pthread
    run_game "$objects"
    (cd "$tree_copy/include" && ls cyclone/*.h) |
        quietly xargs -P2 -I{} sh -c "echo '#include <{}>' | $1 $flags -I'$tree_copy/include' -fsyntax-only -xc++ -"
    passed "copied into an engine's tree, $1 $2, without exceptions and RTTI, and every header alone"
}

windows() { # NAME OPTIONS...
    local compiler=x86_64-w64-mingw32-g++-posix
    local cross=(-DCMAKE_SYSTEM_NAME=Windows -DCMAKE_CXX_COMPILER=$compiler -DCMAKE_BUILD_TYPE=Debug)
    install_library "$1" "${cross[@]}" "${@:2}"
    build "$here/package" "$work/$1-game" "${cross[@]}" -Dcyclone_DIR="$work/$1/lib/cmake/cyclone"
    quietly objdump -p "$work/$1-game/game.exe"
    says 'DLL Name: KERNEL32.dll'
    if command -v wine >/dev/null; then
        WINEPATH=$work/$1/bin quietly wine "$work/$1-game/game.exe"
        says 'falls as it should'
        passed "$1: linked, and run by wine"
    else
        passed "$1: linked"
    fi
}

debugger() {
    printf '#include <cyclone/cyclone.h>\n%s\n' 'cyclone::Vector3 vector(1, -2.5, 0.1);' \
        'cyclone::Quaternion turn(0.5, -0.5, 0.5, 0.5);' 'cyclone::Matrix3 tensor(1, 2, 3, 4, 5, 6, 7, 8, 9);' \
        'cyclone::RigidBody body;' 'int main() {}' >"$work/shown.cpp"
    quietly g++ -std=c++17 -g -I"$tree/include" "$work/shown.cpp" "$work"/static/lib*/libcyclone.a -o "$work/shown"
    quietly gdb -nx -batch -ex "source $work/static/share/cyclone/cyclone_gdb.py" -ex 'print vector' -ex 'print turn' \
        -ex 'print tensor' -ex 'print body' "$work/shown"
    diff "$work/log" - <<'SHOWN'
$1 = (1, -2.5, 0.1)
$2 = 0.5-0.5i+0.5j+0.5k
$3 = [1 2 3; 4 5 6; 7 8 9]
$4 = 1 kg at (0, 0, 0), orientation 1+0i+0j+0k, velocity (0, 0, 0), rotation (0, 0, 0)
SHOWN
    passed "gdb shows vectors, quaternions, matrices and bodies"
}

install_library static
package static
pkgconfig static
install_library shared -DBUILD_SHARED_LIBS=ON -DCMAKE_BUILD_TYPE=Debug
package shared
pkgconfig shared
shared_lets_out_its_interface_only

guest add_subdirectory -DCMAKE_BUILD_TYPE=Debug
guest FetchContent -DCMAKE_BUILD_TYPE=Debug -DBY_FETCHCONTENT=ON -DBUILD_SHARED_LIBS=ON

mkdir "$work/engine"
cp -r "$tree/include" "$tree"/src/*.{h,cpp} "$here/falling.cpp" "$work/engine"
copied g++ c++17
copied clang++ c++20

windows windows-static
windows windows-dll -DBUILD_SHARED_LIBS=ON

if command -v gdb >/dev/null; then debugger; else echo "gdb is not here"; fi
echo "Cyclone works for its users: $cases cases."
