/* The line that the water draws over the lens of an eye which is half in it. The lens is as large as the near plane. */
uniform int line_there; /* 0: all of the lens is on one side */

/* m that the lens stands above the water at a place of the picture. */
float line_height(vec2 place)
{
    vec3 ray = ahead + (2.0 * place.x - 1.0) * right + (2.0 * place.y - 1.0) * up;
    vec3 lens = eye + ray * (planes.x / dot(ray, normalize(cross(up, right))));
    return lens.y - waves_height(lens.xz, 0.0);
}

/* On which side of the water the lens is there: 1 above, -1 below. */
float line_side(vec2 place)
{
    return line_there == 0 ? side : line_height(place) < 0.0 ? -1.0 : 1.0;
}
