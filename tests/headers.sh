#!/bin/sh
# headers.sh FOLDER CC CXX: each public header compiles alone, as C11 and as C++17, without a warning.
set -u
folder=$1 cc=$2 cxx=$3
status=0

# $cc and $cxx are commands with arguments.
for header in "$folder"/*.h; do
    name=dapple/$(basename "$header")
    echo "$name"
    text="#include \"$name\"
extern int not_empty;"
    echo "$text" | $cc -std=c11 -x c -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wundef \
        -Wstrict-prototypes -Werror -fsyntax-only -I "$folder/.." - || status=1
    echo "$text" | $cxx -std=c++17 -x c++ -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wundef \
        -Wold-style-cast -Werror -fsyntax-only -I "$folder/.." - || status=1
done
exit $status
