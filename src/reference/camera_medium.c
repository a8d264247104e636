#include "reference/camera_medium.h"

#include "base/vector3.h"

#include "base/sine.h"
#include "optics/phase.h"

static double extinction(const struct camera_water *water, int color)
{
    return water->optics.absorption[color] + water->optics.scattering[color];
}

double camera_medium_left(const struct camera_water *water, int color, double length)
{
    return exp(-extinction(water, color) * length);
}

double camera_medium_most_left(const struct camera_water *water, double length)
{
    return fmax(fmax(camera_medium_left(water, 0, length), camera_medium_left(water, 1, length)),
                camera_medium_left(water, 2, length));
}

void camera_medium_turn(double anisotropy, struct draws *draws, double direction[3])
{
    double cosine = optics_phase_cosine(draws_next(draws), anisotropy), axis[3], sine_turn, cosine_turn;
    double sine = sqrt(1 - cosine * cosine);
    sine_cosine(draws_next(draws), &sine_turn, &cosine_turn);
    vector3_copy(direction, axis);
    vector3_turn(axis, (const double[3]){sine * cosine_turn, sine * sine_turn, cosine}, direction);
    vector3_normalize(direction);
}

/* The density of ending at `distance` for being scattered, or the share that comes that far, over the colours that the
 * path has; one of them is drawn to say how far. */
bool camera_medium_walk(const struct camera_water *water, double length, struct draws *draws, double throughput[3],
                        double *distance)
{
    int colors[3], count = 0;
    for (int c = 0; c < 3; c++)
        if (throughput[c] > 0)
            colors[count++] = c;
    *distance = length;
    bool scattered = false;
    if (count > 0 && vector3_most(water->optics.scattering) > 0) {
        double drawn = draws_next(draws) * count, way = -log(1 - draws_next(draws));
        way /= extinction(water, colors[(int)drawn]); /* infinite where nothing stops it */
        scattered = way < length;
        *distance = scattered ? way : length;
    }
    double density = 0;
    for (int i = 0; i < count; i++) {
        double left = camera_medium_left(water, colors[i], *distance);
        density += (scattered ? extinction(water, colors[i]) : 1) * left / count;
        throughput[colors[i]] *= (scattered ? water->optics.scattering[colors[i]] : 1) * left;
    }
    for (int i = 0; i < count && vector3_most(water->optics.scattering) > 0; i++)
        throughput[colors[i]] = density > 0 ? throughput[colors[i]] / density : 0;
    return scattered;
}

double camera_medium_place(const struct camera_water *water, double length, double draw, double *distance)
{
    double least = fmin(fmin(extinction(water, 0), extinction(water, 1)), extinction(water, 2));
    double gone = -expm1(-least * length);
    if (least * length < 1e-6) {
        *distance = draw * length;
        return 1 / length;
    }
    *distance = -log1p(-draw * gone) / least;
    return least * exp(-least * *distance) / gone;
}
