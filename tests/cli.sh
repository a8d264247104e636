#!/bin/sh
# What a user sees of the program: every command, every flag, every error and its exit code.
# Argument: the program. Prints what failed; exits 1 then.
set -u
dapple=$(realpath "$1") || exit 1
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/work" && cd "$scratch/work" || exit 1
failures=0
out=$scratch/out err=$scratch/err # of the command run last
no_gl='env __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null'

fail() {
    echo "FAILED: $*"
    sed 's/^/    /' "$out" "$err" | head -n 5
    failures=$((failures + 1))
}

# run CODE COMMAND...: it must exit with that code.
run() {
    expected=$1
    shift
    "$@" >"$out" 2>"$err" </dev/null
    code=$?
    [ $code = "$expected" ] || fail "exit code $code, not $expected: $*"
}

# works ARGUMENT...
works() {
    run 0 "$dapple" "$@"
    [ ! -s "$err" ] || fail "messages on stderr: $*"
}

# refuses CODE TEXT ARGUMENT...: exits so, with one error that contains the text, and leaves no file.
refuses() {
    code_wanted=$1 text=$2
    shift 2
    run "$code_wanted" "$dapple" "$@"
    grep -q '^dapple: error: ' "$err" && grep -qF -e "$text" "$err" || fail "no error with '$text': $*"
    [ "$(grep -c '^dapple: error: ' "$err")" = 1 ] || fail "more than one error: $*"
    [ ! -s "$out" ] || fail "something on stdout: $*"
    left=$(ls -A)
    [ -z "$left" ] || fail "left behind: $left: $*"
    rm -rf ./*
}

says() {
    grep -qF -e "$1" "$out" || fail "stdout does not say '$1'"
}

# json EXPRESSION: stdout is one JSON object of which the Python expression is true.
json() {
    python3 -c "import json, sys; o = json.load(sys.stdin); sys.exit(not (isinstance(o, dict) and ($1)))" <"$out" ||
        fail "not JSON of which this is true: $1"
}

# holds FILE...: these and no other files are in the working folder; removes them.
holds() {
    wanted=$(for name; do echo "$name"; done | sort)
    found=$(ls -A | sort)
    [ "$found" = "$wanted" ] || fail "files: $(echo $found), not: $*"
    for name; do
        [ -s "./$name" ] || fail "empty or missing: $name"
    done
    rm -rf ./*
}

# probe FILE KEY: a value of the video stream.
probe() {
    ffprobe -v error -count_frames -select_streams v:0 -show_entries "stream=$2" -of default=nw=1:nk=1 "$1"
}

# --- help ---
works && says 'usage: dapple COMMAND'
works --help && says 'examples:'
works --version && says 'dapple '
for command in render map surface compare bench view list info help; do
    works help $command && says "usage: dapple $command" && says 'examples:' && says --help
    cp "$out" "$scratch/help"
    works $command --help
    cmp -s "$out" "$scratch/help" || fail "$command --help is not help $command"
done
refuses 2 'did you mean "render"' rendr
refuses 2 'accepted: render, map' --json
refuses 2 'did you mean "surface"' help surfaces
refuses 2 'one word too many' help map surface

# --- flags ---
refuses 2 'unknown flag: "--fast" (did you mean "--fps"? accepted: --output, --set' render --fast
refuses 2 'unknown flag: "--white"' render --white 2 -o a.png
refuses 2 'unknown flag: "--size=8x8"' map --size=8x8 -o a.png
refuses 2 'unknown flag: "-j"' info -j
refuses 2 '--time: a value is missing' map -o a.exr --time
refuses 2 '--json: takes no value' map -o a.exr --json=1
refuses 2 'one word too many: "collard-2"' map collard-1 collard-2 -o a.exr
for value in nan inf -inf '' ' 1' 1x 0x10 1e7 -1e7 1e999; do
    refuses 2 '--time: ' map -o a.exr --time "$value"
done
for value in 0 -1 1.5 100001 99999999999999999999 nan; do
    refuses 2 '--frames: ' map -o a-%d.exr --frames "$value"
done
for value in 0 0.001 1001 nan; do
    refuses 2 '--fps: ' map -o a.exr --fps "$value"
done
for value in 0x8 8x0 16385x8 8 8x 8x8x8 -8x8 8X8 8x99999999999999999999; do
    refuses 2 '--size: ' render -o a.png --size "$value"
done
for value in 0 -1 nan 1e7; do
    refuses 2 '--white: ' map -o a.png --white "$value"
done
refuses 2 'one of 8, 16' map -o a.png --bits 12
refuses 2 'one of auto, gl, cpu' map -o a.png --device gpu
refuses 2 'caustics.map: out of range: "0"' map -o a.png --map 0
refuses 2 'caustics.map: out of range: "1000000000"' map -o a.png --map 1000000000
refuses 2 'caustics.technique: no such choice: "magic" (accepted: one of ' map -o a.png --technique magic
refuses 2 'scene.seed: ' map -o a.png --seed x
refuses 2 '--set: no "="' map -o a.png --set sun.elevation
refuses 2 'no such section: "moon"' map -o a.png --set moon.phase=1
refuses 2 'no such key: "height"' map -o a.png --set sun.height=1
refuses 2 'sun.elevation: not a number: "high"' map -o a.png --set sun.elevation=high
refuses 2 'sun.elevation: out of range: "91"' map -o a.png --set sun.elevation=91
refuses 2 'sun.elevation: out of range: "nan"' map -o a.png --set sun.elevation=nan
refuses 2 'section.key' map -o a.png --set depth=1

# --- scenes ---
mkdir "$scratch/scenes"
head -c 1000 /dev/urandom >"$scratch/scenes/noise.ini"
printf '[scene]\ndepth = 1\nthis is no line\n' >"$scratch/scenes/line.ini"
printf '[scene]\n\ndeep = 1\n' >"$scratch/scenes/key.ini"
printf '[water]\nmodel = sines\n[wave.1]\ncycles = 2 1\n[scene]\nloop = 0.2\n' >"$scratch/scenes/sines.ini"
refuses 2 'missing.ini' map missing.ini -o a.png
refuses 2 'not a regular file' map "$scratch/scenes" -o a.png
refuses 2 'noise.ini' map "$scratch/scenes/noise.ini" -o a.png
refuses 2 'line.ini:3: ' map "$scratch/scenes/line.ini" -o a.png
refuses 2 'key.ini:3: scene.deep: no such key' map "$scratch/scenes/key.ini" -o a.png
refuses 2 'neither a file nor a built-in scene' map '' -o a.png

# --- output ---
for command in render map surface; do
    refuses 2 "dapple $command -o" $command
    refuses 2 'accepted: .png, .exr, .pfm' $command -o a.jpg
    refuses 2 'accepted: .png, .exr, .pfm' $command -o a
    refuses 2 'cannot be written' $command -o missing/a.png
    refuses 2 'cannot be written' $command -o /proc/a.png
    refuses 2 'cannot be written' $command -o "$out/a.png"
    refuses 2 '%04d' $command -o a.png --frames 2
    for name in a-%s.png a-%4d.png a-%00d.png a-%010d.png a-%d-%d.png a%.png; do
        refuses 2 'not a name for numbered files' $command -o $name
    done
done
mkdir "$scratch/folder.png"
refuses 2 'is a folder' map -o "$scratch/folder.png"
refuses 2 'accepted: .png, .exr, .pfm)' map -o a.mp4
refuses 2 '--bits: only a .png' map -o a.exr --bits 16
refuses 2 '--white: only a .png' map -o a.pfm --white 2
refuses 2 '--slice: ' map -o a.pfm --slice -1
refuses 2 'slice: out of range: "2" (accepted: 0 to 1, as' map -o a.pfm --set caustics.slices=2 --slice 2
refuses 2 'a video is one file' render -o a-%04d.mp4
refuses 2 'even width and height' render -o a.mp4 --size 33x32
refuses 2 'at most 50' render -o a.gif --fps 60
refuses 2 'too many' render -o a.mp4 --set scene.loop=3600 --fps 1000

# --- map and surface ---
small='--map 32'
works map rings $small -o a.exr && says 'a.exr: 32 x 32, 1 frame in' && holds a.exr
works map rings $small --quiet -o a.exr && [ ! -s "$out" ] || fail 'map --quiet prints'
holds a.exr
works map collard-2 $small --json --output=a.png --white=4 --bits 16 --time -1.5 --device cpu --seed 3
json 'o["output"] == "a.png" and o["frames"] == 1 and o["width"] == o["height"] == 32 and o["seconds"] > 0'
json 'o["min"] <= o["mean"] <= o["max"]'
file_type=$(od -An -tu1 -j24 -N1 a.png) # the bit depth in a PNG's header
[ "$file_type" -eq 16 ] || fail 'map --bits 16 is not of 16 bits'
holds a.png
works map rings $small --frames 3 --fps 10 -o 'a-%03d.pfm' && says '3 frames'
cp a-001.pfm "$scratch/second.pfm"
holds a-000.pfm a-001.pfm a-002.pfm
works map rings $small --time 0.1 -o a.pfm
cmp -s a.pfm "$scratch/second.pfm" || fail 'frame i is not at time + i / fps'
holds a.pfm
works map "$scratch/scenes/sines.ini" $small --device gl --technique multi-sample --set multi-sample.steps=2 -o ./-a.exr
holds -a.exr
works surface rings --json -o a.pfm && json 'o["width"] == o["height"] == 161 and o["height_range"] > 0' && holds a.pfm
works surface rings --frames 2 -o a%d.png && says 'slope_x_range' && holds a0.png a1.png
works surface -o a.exr -- collard-3 && holds a.exr

# --- pictures ---
works render rings -o a.png --size 64x36 && says '64 x 36' && holds a.png
works render rings -o a.EXR --size 7x5 --json && json 'o["width"] == 7 and o["height"] == 5' && holds a.EXR
works render rings -o a-%04d.png --size 16x16 --frames 2 $small && holds a-0000.png a-0001.png
name='quote" \ and
line.png'
works render rings -o "$name" --size 16x16 $small --json && json 'o["output"] == "quote\" \\ and\nline.png"' && holds "$name"
works map -o "$(printf 'byte-\377.png')" $small --json && json 'o["output"] == "byte-\ufffd.png"'
rm -rf ./*

# --- compare ---
compared="--map 32 --set reference.photons=16"
run 0 "$dapple" compare $compared && says 'coverage  '
for command in "compare --technique multi-sample" "compare --against multi-sample --technique reference"; do
    works $command $compared && says 'technique       error %    p99 %   energy     gain     FLIP        ms'
    grep -Eq '^(multi-sample|reference) +[0-9.]+ ' "$out" || fail "$command: no row"
done
works compare $compared --technique multi-sample --technique reference --json -o sheet.png
json '[t["technique"] for t in o["techniques"]] == ["multi-sample", "reference"] and o["against"] == "reference"'
json 'o["noise"] > 0 and o["map"] == 32 and o["output"] == "sheet.png" and o["device"]'
json 'all(t["failure"] is None and t["energy"] > 0 and t["ms"] > 0 for t in o["techniques"])'
json 'o["techniques"][0]["error"] > 0.01 and 0 < o["techniques"][0]["flip"] < 1 and not o["techniques"][0]["physical"]'
json 'o["techniques"][1]["error"] == o["techniques"][1]["p99"] == o["techniques"][1]["flip"] == 0'
json 'o["techniques"][1]["energy"] == o["techniques"][1]["gain"] == 1'
holds sheet.png
works compare $compared --against multi-sample --technique multi-sample --device cpu -o sheet.exr --json
json 'o["techniques"][0]["flip"] == o["techniques"][0]["error"] == 0 and o["techniques"][0]["gain"] == 1'
holds sheet.exr
# what looks different does, wherever the camera looks: here, upwards
works compare $compared --technique multi-sample --set 'camera.target=0 9 0' --json && json '0.01 < o["techniques"][0]["flip"] < 1'
# a technique that cannot serve the scene is a row with the reason
works compare $compared --technique multi-sample --set caustics.ceiling=2 -o sheet.png && says 'multi-sample   not shown: ' && holds sheet.png
works compare $compared --technique multi-sample --set caustics.ceiling=2 --json && json 'o["techniques"][0]["failure"]'
# a reference that is too noisy to tell
run 0 "$dapple" compare $compared --technique coverage --set reference.photons=1 --set collard.amplitude=0.01
grep -q '^dapple: warning: reference: its noise of ' "$err" || fail 'no warning of a noisy reference'
works compare --seconds 0.1 $compared --technique multi-sample --map 64 --set reference.photons=100000 --set reference.noise=0
refuses 2 '--against: no such technique: "magic" (accepted: coverage' compare --against magic -o sheet.png
refuses 2 'caustics.technique: no such choice: "magic"' compare --technique multi-sample --technique magic -o sheet.png
refuses 2 'accepted: .png, .exr, .pfm' compare -o sheet.jpg
refuses 2 'cannot be written' compare -o missing/sheet.png
refuses 2 '--seconds: ' compare --seconds -1 -o sheet.png
refuses 2 'unknown flag: "--frames' compare --frames 2
refuses 2 'one word too many' compare rings collard-2
run 0 $no_gl "$dapple" compare $compared --technique multi-sample --json && json 'o["techniques"][0]["flip"] > 0'

# --- compare: looks ---
looks="rings --size 17x13 --map 32 --set look.path-traced.passes=1 --set look.path-traced.mesh=32"
works compare $looks --look path-traced --set render.look=path-traced --json
json 'o["look"] == o["against"] == "path-traced" and o["error"] == o["p99"] == o["flip"] == 0 and o["energy"] == 1'
json 'o["width"] == 17 and o["height"] == 13 and o["output"] is None and o["seconds"] > 0 and o["against_seconds"] > 0'
works compare $looks --look path-traced --set render.look=collard -o sheet.png
says 'look            error %    p99 %   energy     FLIP         s' && holds sheet.png
works compare $looks --look path-traced --set render.look=collard --json && json 'o["error"] > 0.1 and 0.01 < o["flip"] < 1'
refuses 2 '--look: no such look: "magic" (accepted: ' compare --look magic -o sheet.png
refuses 2 '--against: "coverage" (accepted: none where' compare --look physical --against coverage
refuses 2 '--size: too small to compare: "3x9"' compare --look physical --size 3x9
run 1 $no_gl "$dapple" compare $looks --look path-traced

# --- videos ---
if command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null; then
    video='--size 64x48 --map 32 --fps 25'
    works render rings $video --frames 12 -o a.mp4 && says '12 frames'
    [ "$(probe a.mp4 codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames | xargs)" = \
        'h264 64 48 yuv420p 25/1 12' ] || fail 'a.mp4 is not what was asked for'
    holds a.mp4
    works render rings $video --frames 12 -o a.webm
    [ "$(probe a.webm codec_name,width,nb_read_frames | xargs)" = 'vp9 64 12' ] || fail 'a.webm is not as wanted'
    holds a.webm
    works render rings $video --frames 12 --size 33x31 -o a.gif
    [ "$(probe a.gif codec_name,width,nb_read_frames | xargs)" = 'gif 33 12' ] || fail 'a.gif is not as wanted'
    holds a.gif
    works render "$scratch/scenes/sines.ini" $video -o a.mp4 --json && json 'o["frames"] == 5' && holds a.mp4
    # an ffmpeg that fails, and one that dies
    mkdir "$scratch/fails" "$scratch/dies"
    printf '#!/bin/sh\nexit 3\n' >"$scratch/fails/ffmpeg"
    printf '#!/bin/sh\nkill -9 $$\n' >"$scratch/dies/ffmpeg"
    chmod +x "$scratch/fails/ffmpeg" "$scratch/dies/ffmpeg"
    real_path=$PATH
    PATH=$scratch/fails:$real_path refuses 1 'exit code 3' render rings $video -o a.mp4
    PATH=$scratch/dies:$real_path refuses 1 'signal 9' render rings $video -o a.mp4
    # a folder that takes the video away from under it
    mkdir "$scratch/full" && mount -t tmpfs -o size=4k none "$scratch/full" 2>/dev/null && {
        refuses 1 'a.mp4' render rings $video --size 320x240 --frames 8 -o "$scratch/full/a.mp4"
        refuses 1 'a.exr' map --map 128 -o "$scratch/full/a.exr"
        [ -z "$(ls -A "$scratch/full")" ] || fail 'a full disk keeps half a file'
        umount "$scratch/full"
    }
fi
mkdir "$scratch/empty"
old_path=$PATH
PATH=$scratch/empty
code=0
"$dapple" render -o a.mp4 >"$out" 2>"$err" || code=$?
PATH=$old_path
[ $code = 1 ] && grep -q 'apt install ffmpeg' "$err" || fail 'no clear error without ffmpeg'

# --- signals: no half file stays ---
# interrupted SIGNAL ARGUMENT...: starts the program, waits for its first file, ends it so.
interrupted() {
    signal=$1
    shift
    "$dapple" "$@" >"$out" 2>"$err" &
    child=$!
    tries=0
    while [ -z "$(ls -A)" ] && [ $tries -lt 200 ]; do
        sleep 0.05
        tries=$((tries + 1))
    done
    kill -s "$signal" $child
    wait $child 2>/dev/null && fail "SIG$signal did not end it: $*"
    case $(ls -A) in
    *.part*) fail "SIG$signal left $(ls -A): $*" ;;
    esac
}
interrupted TERM map rings --map 256 --frames 100000 -o a-%d.exr
rm -rf ./*
if command -v ffmpeg >/dev/null; then
    interrupted TERM render rings --size 64x48 --map 32 --frames 100000 -o a.mp4
    [ -z "$(ls -A)" ] || fail "SIGTERM left $(ls -A)"
fi
rm -rf ./*

# --- without OpenGL ---
run 1 $no_gl "$dapple" render -o a.png
grep -q 'error: no OpenGL' "$err" || fail 'render without OpenGL does not say so'
run 1 $no_gl "$dapple" bench
run 1 $no_gl "$dapple" map --device gl -o a.exr
holds
run 0 $no_gl "$dapple" map $small -o a.exr
[ "$(wc -l <"$err")" = 1 ] && grep -q 'warning: .*computing on the CPU' "$err" || fail 'not one line of warning'
holds a.exr
run 0 $no_gl "$dapple" surface --device cpu -o a.exr
[ ! -s "$err" ] || fail 'surface --device cpu looks for OpenGL'
holds a.exr
run 0 $no_gl "$dapple" info && says 'none (no OpenGL'
run 0 $no_gl "$dapple" info --json && json 'o["opengl"] is None and o["no_opengl"]'

# --- shaders from a folder ---
refuses 2 'empty' render -o a.png --shaders "$scratch/empty"

# --- bench, info, list ---
works bench rings --size 32x32 --frames 2 $small && says 'whole frame'
works bench collard-4 --size 32x32 --frames 2 $small --json
json 'o["scene"] == "collard-4" and o["technique"] == "multi-sample" and o["size"] == [32, 32] and o["map"] == 32'
json 'o["frames"] == 2 and o["frame_ms"]["min"] <= o["frame_ms"]["median"] <= o["frame_ms"]["max"] and o["device"]'
json '[p["name"] for p in o["passes"]][0] == "surface" and all(p["ms"] >= 0 for p in o["passes"])'
works info && says 'OpenGL'
works info --json && json 'o["version"] and o["threads"] > 0 and o["opengl"]["texture_max"] >= 2048'
works list scenes && says collard-1
works list waters && says sines
works list techniques && says multi-sample
works list params && says sun.elevation && says wave.1.cycles
works list params --markdown && says '| `elevation` | `60` |'
for what in scenes waters techniques params; do
    works list $what --json && json "len(o['$what']) > 0"
done
refuses 2 'accepted: scenes, waters, techniques, looks, shapes, params' list
refuses 2 'accepted: scenes, waters, techniques, looks, shapes, params' list fish
refuses 2 'did you mean "looks"' list look
refuses 2 'did you mean "params"' list param
works list looks && says collard
works list params sun.e && says sun.elevation
grep -qF sun.azimuth "$out" && fail "list params PREFIX lists others too"
refuses 2 'starts so: "moon"' list params moon
refuses 2 'one word too many: "sun."' list scenes sun.
refuses 2 'did you mean "collard-1"' render colard-1 -o a.png
refuses 2 'did you mean "coverage"' map --technique covrage -o a.png
refuses 2 'did you mean "elevation"' render --set sun.elevaton=3 -o a.png
printf '[object.gull]\nshape = mesh\nfile = gull.obj\n' >"$scratch/gull.ini"
refuses 2 "object.gull.file: $scratch/gull.obj: cannot be read: No such file" render "$scratch/gull.ini" -o a.png
refuses 2 'did you mean "sun"' render --set son.elevation=3 -o a.png
refuses 2 '--markdown: only for params' list scenes --markdown

# --- the ground truth ---
truth="$small --technique reference --set reference.photons=64"
works list techniques --json && json '[t["refines"] for t in o["techniques"] if t["name"] == "reference"] == [True]'
works map $truth --json -o a.pfm && json '0 < o["noise"] < 0.2 and 0.5 < o["mean"] < 1'
mv a.pfm "$scratch/truth.pfm"
photons=$scratch/photons
works map $truth --seconds 0 --set reference.file="$photons" -o a.pfm && says 'noise '
cmp -s a.pfm "$scratch/truth.pfm" && fail '--seconds 0 does not stop'
works map $truth --set reference.file="$photons" -o a.pfm
cmp -s a.pfm "$scratch/truth.pfm" || fail 'a map in two runs is not that of one'
holds a.pfm
refuses 2 'photons: its photons are those of another scene' map $truth --time 1 --set reference.file="$photons" -o a.pfm
refuses 2 '--seconds: ' map $truth --seconds -1 -o a.pfm
rm "$photons"
# its signal comes after the first pass, which is long over when the file is there
"$dapple" map $truth --device cpu --set reference.photons=1000000 --set reference.file="$photons" -o a.pfm 2>"$err" &
child=$!
sleep 2
kill -s TERM $child
wait $child 2>/dev/null && fail 'SIGTERM did not end the ground truth'
[ -s "$photons" ] && [ -z "$(ls -A)" ] || fail "SIGTERM: no photons kept, or a map: $(ls -A)"

# --- a stdout that cannot be written ---
for command in help info 'list params' "map $small -o a.exr"; do
    code=0
    "$dapple" $command >/dev/full 2>"$err" || code=$?
    [ $code = 1 ] || fail "$command on a full disk: exit code $code, not 1"
    code=0
    "$dapple" $command >&- 2>"$err" || code=$?
    [ $code = 1 ] || fail "$command with stdout closed: exit code $code, not 1"
done
rm -rf ./*

[ $failures = 0 ] || echo "$failures failed"
[ $failures = 0 ]
