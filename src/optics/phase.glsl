/* The GPU's twin of phase.c. */

float optics_phase(float cosine, float anisotropy)
{
    float g = anisotropy;
    float square = max((1.0 - g) * (1.0 - g) + 2.0 * g * (1.0 - cosine), 1e-8);
    return (1.0 - g * g) / (12.566370614 * square * sqrt(square));
}
