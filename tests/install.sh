#!/bin/sh
# install.sh ROOT BUILD CC: the installed library as a stranger meets it: what it exports and needs, and the example
# compiled against it through pkg-config alone.
set -eu
root=$1 build=$2 cc=$3
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
trap 'exit 1' INT TERM

fail() {
    echo "$1"
    exit 1
}

DESTDIR=$place meson install -C "$build" --no-rebuild --quiet
library=$(find "$place" -name 'libdapple.so.*.*')
[ -f "$library" ] || fail "no library was installed: $library"

exported=$(nm --dynamic --defined-only --format=posix "$library" | cut -d ' ' -f 1)
echo "$exported" | grep -q '^dpl_renderer_draw$' || fail "the library exports no dpl_renderer_draw"
stray=$(echo "$exported" | grep -v '^dpl_' || true)
[ -z "$stray" ] || fail "the library exports names without dpl_: $stray"
opengl=$(readelf --dynamic "$library" | grep -E 'NEEDED.*lib(GL|EGL|OpenGL|GLESv2)' || true)
[ -z "$opengl" ] || fail "the library links OpenGL: $opengl"

PKG_CONFIG_PATH=$(dirname "$(find "$place" -name dapple.pc)")
PKG_CONFIG_SYSROOT_DIR=$place
export PKG_CONFIG_PATH PKG_CONFIG_SYSROOT_DIR
cd "$place"
# $cc and what pkg-config says are words.
$cc "$root/examples/caustics.c" -Wall -Wextra -Werror $(pkg-config --cflags --libs dapple glfw3) -o caustics
LD_LIBRARY_PATH=$(dirname "$library") xvfb-run --auto-servernum ./caustics --once

# A frame that was drawn has both dark and bright pixels; one that was not is of one colour.
spread=$(convert caustics.png -colorspace Gray -format '%[fx:maxima-minima]' info:)
awk -v spread="$spread" 'BEGIN { exit !(spread > 0.2) }' || fail "the example's picture is of one colour: $spread"
