/* The fragment stage of passes that have found the light in an earlier one. */
#ifdef FRAGMENT
in vec3 light;
out vec4 color;

void main()
{
    color = vec4(light, 1.0);
}
#endif
