# The eyes and hands of viewer.sh, which reads this file: what the screen shows, the mouse, and waiting for the window.

# try SECONDS COMMAND…: repeats the command until it succeeds.
try() {
    end=$(($(date +%s) + $1))
    shift
    until "$@"; do
        [ "$(date +%s)" -lt $end ] || return 1
        sleep 0.1
    done
}

# screen NAME [AREA]: the area (default: the whole window) as NAME.png, from the file in which Xvfb keeps its screen.
screen() {
    convert "xwd:$folder/Xvfb_screen0" -crop "${2:-${width}x$height+0+0}" +repage -quality 1 "$folder/$1.png"
}

# differ A B: how far two pictures are apart, in thousandths of full brightness.
differ() {
    compare -metric RMSE "$folder/$1.png" "$folder/$2.png" null: 2>&1 | sed 's/.*(\(.*\))/\1/' |
        awk '{ printf "%d\n", $1 * 1000 + 0.5 }'
}

# rests NAME: two pictures of the screen in a row are the same, and are NAME.png.
rests() {
    screen before "$middle"
    frames
    screen "$1" "$middle"
    [ "$(differ before "$1")" -eq 0 ]
}

# shows_other NAME OTHER [LEAST]: the picture is at rest and is not OTHER.png.
shows_other() {
    rests "$1" && [ "$(differ "$1" "$2")" -gt "${3:-4}" ]
}

shows_same() {
    rests "$1" && [ "$(differ "$1" "$2")" -le 1 ]
}

moves() {
    screen before "$middle"
    frames
    screen after "$middle"
    [ "$(differ before after)" -gt 2 ]
}

# What stands in the rows of the times.
meter() {
    tail -c "$screen_size" "$folder/Xvfb_screen0" | tail -c +$((screen_width * 4 * times_top + 1)) |
        head -c $((screen_width * 4 * times_height)) | cksum
}

ticked() {
    [ "$(meter)" != "$tick" ]
}

# Waits until the window has seen what the mouse did: a frame may have been under way, and a quick click is seen as
# pressed in one frame and as released in the next.
frames() {
    for _ in 1 2 3 4; do
        tick=$(meter)
        waited=0
        until ticked; do
            sleep 0.02
            waited=$((waited + 1))
            [ $waited -lt 1000 ] || fail "the window stands still"
        done
    done
}

point() {
    xdotool mousemove "$1" "$2"
    frames
}

click() {
    point "$1" "$2"
    xdotool click 1
    frames
}

# drag X Y X Y [BUTTON]
drag() {
    point "$1" "$2"
    xdotool mousedown "${5:-1}"
    frames
    point "$3" "$4"
    xdotool mouseup "${5:-1}"
    frames
}

find_window() {
    window=$(xdotool search --onlyvisible --name '^dapple' 2>/dev/null | head -n 1)
    [ -n "$window" ]
}

is_drawn() {
    screen first "$middle"
    [ "$(convert "$folder/first.png" -format '%[fx:standard_deviation > 0.02]' info:)" = 1 ]
}
