# Uses the window as a person does, on a display of its own, and checks what the screen shows.
# usage: viewer.sh DAPPLE [SHADERS]     SHADERS: the source's src/ (default: beside this script)
# KEEP=1 keeps the pictures of the screen and says where.
set -u
dapple=$(realpath "$1")
shaders=${2:-$(dirname "$0")/../src} scenes=$(dirname "$0")/../scenes
for tool in Xvfb xdotool compare convert; do
    command -v $tool >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done
"$dapple" info | grep -q '^viewer  *yes' || { echo "skipped: this build has no viewer"; exit 77; }

# Places in a window of 1280 × 720 at a scale of 1.
width=1280 height=720
middle=640x600+380+20        # of the picture, clear of the panels: WxH+X+Y
times_top=36 times_height=220  # rows of the times of the passes, which change with every frame
screen_width=1600 screen_height=1000
screen_size=$((screen_width * screen_height * 4)) # bytes
scene_menu='180 45'          # the menu; its first line and the distance to the next stand below it
entry_x=60 entry_y=70 entry_step=17
save_button='260 91'
path_header='120 298'
time_early='100 344 70 344' time_late='70 344 180 344' time_middle='180 344 120 344'
clear_button='294 321' # below it, while it is open
depth_from='120 417' depth_to='40 417' # the slider of scene.depth, and of [scene] the button "reset"
scene_reset='316 371'
compare_y=344 with_y=367       # the menus of what is compared; their entries stand below as those of the scenes do
pool_water='560 270' pool_far=80x40+830+280 # a place of the water, and an area far from there
pool_ball='700 295' pool_ball_to='640 280'
left_part=250x500+380+100      # of the picture, left of its middle and right of it
right_part=150x500+645+100

# In memory, if possible: there are file systems on which what Xvfb maps is not what others read.
folder=$(mktemp -d -p /dev/shm 2>/dev/null || mktemp -d) viewer="" display=""
finish() {
    [ -z "$viewer" ] || kill "$viewer" 2>/dev/null
    [ -z "$display" ] || kill "$display" 2>/dev/null
    if [ -n "${KEEP:-}" ]; then echo "pictures: $folder"; else rm -rf "$folder"; fi
}
trap finish EXIT
trap 'exit 1' INT TERM

fail() {
    echo "FAILED: $*"
    cat "$folder/log"
    [ -z "$viewer" ] || ps -o stat,time,wchan:20,args -p "$viewer" || echo "the window has ended"
    exit 1
}

. "$(dirname "$0")/viewer_hands.sh"

# open ARGUMENTS…: starts the viewer and waits for a picture.
open() {
    (cd "$folder" && exec nice "$dapple" view --size ${width}x$height "$@") >"$folder/log" 2>&1 &
    viewer=$!
    try 30 find_window || fail "no window appears"
    xdotool windowfocus "$window"
    try 30 is_drawn || fail "the window stays blank"
}

pause() {
    xdotool key p
    try 20 rests paused || fail "P does not pause"
}

is_gone() {
    ! kill -0 "$viewer" 2>/dev/null
}

close() {
    xdotool key Escape
    try 20 is_gone || fail "Escape does not close the window"
    wait "$viewer" || fail "closed by Escape, the exit code is $?"
    viewer=
}

# The lines of the menu of scenes: a heading, the physical scenes, a heading, the others; no heading without scenes.
menu_lines() {
    usual=$("$dapple" list params | awk '/^ *render.look / { getline; print $NF }')
    "$dapple" list scenes | while read -r name _; do
        look=$(sed -n 's/^look *= *\([a-z-]*\).*/\1/p' "$scenes/$name.ini")
        if [ "${look:-$usual}" = physical ]; then echo "1 $name"; else echo "2 $name"; fi
    done | sort -s -k 1,1 | awk '$1 != group { print "heading" } { group = $1; print $2 }'
}

# choose NAME: in the menu of scenes; then the title has that name.
choose() {
    index=$(echo "$menu" | awk -v name="$1" '$1 == name { print NR - 1 }')
    click $scene_menu
    click $entry_x $((entry_y + entry_step * index))
    point $((width / 2)) $((height / 2))
    [ "$(xdotool getwindowname "$window")" = "dapple - $1" ]
}

has_file() {
    [ -s "$folder/$1" ]
}

# The window, without its panels, is pixel by pixel what the screenshot of that number holds.
check_screenshot() {
    xdotool key F2
    try 20 has_file "dapple-000$1.png" || fail "F2 writes no screenshot"
    [ "$(identify -format '%wx%h' "$folder/dapple-000$1.png")" = "${width}x$height" ] ||
        fail "the screenshot is not as large as the window"
    try 20 filled "$1" || fail "the picture does not fill the window of $width x $height"
}

filled() {
    screen whole
    [ "$(differ whole "dapple-000$1")" -le 1 ]
}

check_presets() {
    cp "$folder/paused.png" "$folder/preset-1.png"
    for number in 2 3 4; do
        try 20 choose collard-$number || fail "the menu does not choose collard-$number"
        try 20 shows_other preset-$number preset-$((number - 1)) || fail "choosing collard-$number changes nothing"
    done
    for pair in '1 2' '1 3' '1 4' '2 3' '2 4' '3 4'; do
        set -- $pair
        [ "$(differ "preset-$1" "preset-$2")" -gt 4 ] || fail "collard-$1 and collard-$2 look the same"
    done
}

# value SECTION KEY FILE: of a scene that was saved.
value() {
    awk -v section="[$1]" -v key="$2" '/^\[/ { inside = $0 == section } inside && $1 == key { print $3 }' "$folder/$3"
}

# save NUMBER: the scene, which becomes the file of that number.
save() {
    click $save_button
    try 20 has_file "dapple-000$1.ini" || fail "the button \"Save scene\" writes nothing"
}

# The camera goes from one key to another one, and a saved scene has both.
check_path() {
    click $path_header
    drag $time_early
    xdotool key k
    drag $time_late
    drag 600 300 700 300
    xdotool key k
    frames
    xdotool key c
    frames
    pause
    drag $time_middle
    save 2
    from=$(value camera.1 position dapple-0002.ini) to=$(value camera.2 position dapple-0002.ini)
    awk -v from="$from" -v to="$to" -v now="$(value camera position dapple-0002.ini)" \
        'BEGIN { exit !(from != to && (now - from) * (to - now) > 0) }' ||
        fail "the camera is not on its way between the keys"
    click $clear_button
    save 3
    [ -z "$(value camera.1 time dapple-0003.ini)" ] || fail "the button \"Clear\" does not take the keys away"
    click $path_header
}

# changes NAME OTHER PROBLEM ACTION…: acts until the picture, NAME.png, is not OTHER.png any more.
changes() {
    name=$1 other=$2 what=$3
    shift 3
    for _ in 1 2 3; do
        "$@"
        point $((width / 2)) $((height / 2))
        try 5 shows_other "$name" "$other" && return
    done
    fail "$what"
}

hold_w() {
    xdotool keydown w
    frames
    xdotool keyup w
}

check_controls() {
    try 20 rests still || fail "the picture does not rest"
    changes slid still "the slider of scene.depth changes nothing" drag $depth_from $depth_to
    changes reset slid "the button reset changes nothing" click $scene_reset
    [ "$(differ reset still)" -le 1 ] || fail "the button reset does not bring the picture back"
    changes orbited still "dragging does not move the camera" drag 600 300 700 330
    changes nearer orbited "the wheel does not move the camera" xdotool click 4
    changes flown nearer "W does not move the camera" hold_w
    changes looked flown "dragging with the right button does not move the camera" drag 600 300 640 320 3
    changes stepped looked "N does not move the water" xdotool key n n n n n n
    save 1
}

# pick Y INDEX: an entry of the menu at that height.
pick() {
    click 100 "$1"
    click $entry_x $(($1 + 25 + entry_step * $2))
    point 900 600
}

# parts_are LEFT RIGHT: whether each part of the picture is as it was without a comparison ("same"), or is not.
parts_are() {
    for part in left right; do
        eval "area=\$${part}_part"
        screen "$part" "$area"
        distance=$(differ $part $part-alone)
        if [ "$1" = same ]; then [ "$distance" -le 1 ]; else [ "$distance" -gt 4 ]; fi || return 1
        shift
    done
}

check_compare() {
    try 20 rests still || fail "the picture does not rest"
    screen left-alone $left_part
    screen right-alone $right_part
    # A quick one: every click waits for several frames.
    other=$("$dapple" list techniques --json | python3 -c 'import json, sys
print([t["name"] for t in json.load(sys.stdin)["techniques"]].index("wavefront"))')
    pick $compare_y 1
    pick $with_y "$other"
    try 20 parts_are same other || fail "a split does not show another technique on the right alone"
    drag 640 400 820 400
    try 20 parts_are same same || fail "the line of a split cannot be dragged"
    drag 820 400 640 400
    try 20 parts_are same other || fail "the line of a split cannot be dragged back"
    pick $compare_y 2
    try 20 parts_are other other || fail "the difference of the maps is not shown"
    screen difference $middle
    for color in 'r - b' 'b - r'; do
        some='%[fx:mean > 0.002]'
        [ "$(convert "$folder/difference.png" -scale 25% -fx "$color > 0.3" -format "$some" info:)" = 1 ] ||
            fail "in the difference of the maps there is nothing of $color"
    done
    pick $compare_y 0
    try 20 shows_same without still || fail "without a comparison the picture is not what it was"
}

resize() {
    width=$1 height=$2
    xdotool windowsize "$window" "$width" "$height"
    sleep 1
    screen "resized-$width"
}

check_window() {
    screen panels
    xdotool key h
    check_screenshot 1
    resize 700 500
    check_screenshot 2
    resize 1500 900
    check_screenshot 3
    resize 1280 720
    xdotool key h
    try 20 shows_panels || fail "H does not bring the panels back"
}

shows_panels() {
    screen whole 300x600+0+0
    convert "$folder/panels.png" -crop 300x600+0+0 +repage "$folder/expected.png"
    [ "$(differ whole expected)" -le 20 ]
}

# A scene's file and a shader that are edited while the window shows them.
check_reload() {
    cp -r "$shaders" "$folder/shaders"
    mkdir "$folder/beside"
    printf '[water]\nmodel = collard\n[render]\nlook = collard\n' >"$folder/beside/pool.ini"
    printf '[caustics]\ntechnique = multi-sample\nmap = 256\n' >>"$folder/beside/pool.ini"
    open beside/pool.ini --shaders shaders
    pause
    xdotool key F3
    try 60 has_file beside/pool-still.png || fail "F3 writes no still picture beside the scene"
    [ "$(identify -format '%wx%h' "$folder/beside/pool-still.png")" = 3840x2160 ] ||
        fail "the still picture is not as large as it should be"
    printf '[scene]\ndepth = 0.3\n' >>"$folder/beside/pool.ini"
    try 20 shows_other edited paused || fail "the scene is not read anew"
    printf 'depth = deep\n' >>"$folder/beside/pool.ini"
    try 20 logged 'pool.ini:10: scene.depth' || fail "no message for a broken scene"
    try 20 shows_same kept edited || fail "a broken scene takes the picture away"
    screen message
    sed '/^    color = /a color.rgb = color.bgr;' "$shaders/render/collard_ground.glsl" \
        >"$folder/shaders/render/collard_ground.glsl"
    try 20 shows_other recolored kept || fail "the shader is not read anew"
    echo 'nonsense' >>"$folder/shaders/render/collard_ground.glsl"
    try 20 logged 'render/collard_ground.glsl' || fail "no message for a broken shader"
    try 20 shows_same survived recolored || fail "a broken shader takes the picture away"
    close
}

logged() {
    grep -q "$1" "$folder/log"
}

# The far side of the pool is not as it was in calm water.
far_side_moves() {
    screen far $pool_far
    [ "$(differ far far-calm)" -gt 3 ]
}

# A hand in the water: the pool's waves, its ball, its sun.
check_pool() {
    rm -f "$folder"/dapple-*.ini
    open pool --set caustics.map=128 --set ripples.drops=0 --set ripples.damping=1 --set render.samples=1
    try 20 rests calm || fail "calm water moves"
    screen far-calm $pool_far
    changes orbited calm "dragging beside the pool does not move the camera" drag 440 650 460 650
    changes calm orbited "dragging beside the pool does not move it back" drag 460 650 440 650
    click $pool_water
    try 60 far_side_moves || fail "a click on the water makes no wave that travels"
    xdotool key space
    try 60 rests waves || fail "space does not pause"
    changes lit waves "L does not move the sun" xdotool key l
    changes moved lit "the ball cannot be dragged" drag $pool_ball $pool_ball_to
    xdotool key g
    save 1
    grep -q '^gravity = true' "$folder/dapple-0001.ini" || fail "G does not switch the ball's gravity on"
    close
}

check_no_display() {
    (unset DISPLAY WAYLAND_DISPLAY; "$dapple" view) >"$folder/log" 2>&1
    [ $? -eq 1 ] || fail "without a display the exit code is not 1"
    logged 'window: cannot be opened' || fail "without a display there is no message"
}

check_no_display
# Without -noreset the display would start anew, and refuse a window meanwhile, whenever the last window closes.
Xvfb -displayfd 3 -screen 0 ${screen_width}x${screen_height}x24 -fbdir "$folder" -noreset -nocursor -nolisten tcp \
    3>"$folder/display" 2>/dev/null &
display=$!
try 20 has_file display || fail "Xvfb does not start"
DISPLAY=:$(cat "$folder/display")
export DISPLAY
open collard-1
try 20 moves || fail "the water does not move"
pause
menu=$(menu_lines)
check_presets
close
open collard-1 --set caustics.map=128 # the rest is of the window; so it is quick
pause
check_controls
check_path
check_compare
check_window
[ ! -e "$folder/imgui.ini" ] || fail "imgui.ini was written"
close
check_reload
check_pool
echo "passed"
