/* The fragment stage of a pass that says where a pixel shows a mesh, and how deep. What is seen there is then computed
 * once for each pixel, however many triangles share it. */
#ifdef FRAGMENT
in vec3 position;
out vec4 place;

void main()
{
    place = vec4(position, gl_FragCoord.z);
}
#endif
