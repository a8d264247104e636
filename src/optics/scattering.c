#include "optics/scattering.h"

#include "base/exponential.h"

#include <math.h>

#define EYE (ATMOSPHERE_GROUND + 2) /* m */

/* What a place in the air scatters and takes away, 1/m. */
struct place {
    float scattered[2][SPECTRUM_COUNT], extinct[SPECTRUM_COUNT];
};

VECTOR_CLONES static void find_sun(const struct atmosphere *atmosphere, const struct atmosphere_columns *columns,
                                   double radius, double sun_cosine, float sun[SPECTRUM_COUNT])
{
    float column[ATMOSPHERE_PARTS], share = (float)atmosphere_sun_share(radius, sun_cosine);
    atmosphere_column(columns, radius, sun_cosine, column);
    for (int w = 0; w < SPECTRUM_COUNT; w++)
        sun[w] = share * exponential(-atmosphere->extinction[ATMOSPHERE_AIR][w] * column[ATMOSPHERE_AIR] -
                                     atmosphere->extinction[ATMOSPHERE_HAZE][w] * column[ATMOSPHERE_HAZE] -
                                     atmosphere->extinction[ATMOSPHERE_OZONE][w] * column[ATMOSPHERE_OZONE]);
}

static void find_place(const struct atmosphere *atmosphere, double radius, struct place *place)
{
    float density[ATMOSPHERE_PARTS];
    atmosphere_density(radius, density);
    for (int w = 0; w < SPECTRUM_COUNT; w++) {
        float air = atmosphere->extinction[ATMOSPHERE_AIR][w] * density[ATMOSPHERE_AIR];
        float haze = atmosphere->extinction[ATMOSPHERE_HAZE][w] * density[ATMOSPHERE_HAZE];
        place->scattered[ATMOSPHERE_AIR][w] = air;
        place->scattered[ATMOSPHERE_HAZE][w] = ATMOSPHERE_HAZE_KEPT * haze;
        place->extinct[w] = air + haze + atmosphere->extinction[ATMOSPHERE_OZONE][w] * density[ATMOSPHERE_OZONE];
    }
}

/* Share of what a step's air sends towards the ray's start that gets there, times the step's length; lowers `left`,
 * the share that gets through all steps up to now. */
VECTOR_CLONES static void pass_step(const struct place *place, float length, float left[SPECTRUM_COUNT],
                                    float share[SPECTRUM_COUNT])
{
    for (int w = 0; w < SPECTRUM_COUNT; w++) {
        float depth = place->extinct[w] * length + 1e-9f, through = exponential(-depth);
        share[w] = left[w] * (1 - through) / depth * length;
        left[w] *= through;
    }
}

/* The sun's cosine in the table: finer where it is low. */
#define LOWEST_SUN -0.15
static double sun_cosine_of(int index)
{
    double place = (double)index / (SCATTERING_SUNS - 1);
    return LOWEST_SUN + (1 - LOWEST_SUN) * place * place;
}

/* m from the earth's middle; finer near the ground. */
static double radius_of(int index)
{
    double place = (double)index / (SCATTERING_HEIGHTS - 1);
    return EYE + (ATMOSPHERE_TOP - 10 - EYE) * place * place;
}

static void look_up(const struct scattering *scattering, double radius, double sun_cosine, float mean[SPECTRUM_COUNT])
{
    double h = sqrt(fmin(fmax((radius - EYE) / (ATMOSPHERE_TOP - 10 - EYE), 0), 1)) * (SCATTERING_HEIGHTS - 1);
    double s = sqrt(fmin(fmax((sun_cosine - LOWEST_SUN) / (1 - LOWEST_SUN), 0), 1)) * (SCATTERING_SUNS - 1);
    int row = (int)fmin(h, SCATTERING_HEIGHTS - 2), column = (int)fmin(s, SCATTERING_SUNS - 2);
    float up = (float)(h - row), on = (float)(s - column);
    const float *low = scattering->mean[row][column], *low_next = scattering->mean[row][column + 1];
    const float *high = scattering->mean[row + 1][column], *high_next = scattering->mean[row + 1][column + 1];
    for (int w = 0; w < SPECTRUM_COUNT; w++)
        mean[w] = (low[w] * (1 - on) + low_next[w] * on) * (1 - up) + (high[w] * (1 - on) + high_next[w] * on) * up;
}

/* Adds up one direction's light of the second kind, `second`, and what would come of even light of 1, `even`. */
struct bounce {
    double radius, sun_cosine, ground;
    float second[SPECTRUM_COUNT], even[SPECTRUM_COUNT];
};

static void add_direction(const struct atmosphere *atmosphere, const struct atmosphere_columns *columns, double cosine,
                          double sun_along, float weight, struct bounce *bounce)
{
    const int steps = 12;
    bool meets_ground;
    double length = atmosphere_path(bounce->radius, cosine, &meets_ground);
    float left[SPECTRUM_COUNT], share[SPECTRUM_COUNT], sun[SPECTRUM_COUNT];
    for (int w = 0; w < SPECTRUM_COUNT; w++)
        left[w] = 1;
    for (int i = 0; i < steps; i++) {
        double start = (double)i / steps, end = (double)(i + 1) / steps, at = (start + end) / 2;
        double along = length * at * at;
        double radius = sqrt(bounce->radius * bounce->radius + along * along + 2 * bounce->radius * cosine * along);
        struct place place;
        find_place(atmosphere, radius, &place);
        find_sun(atmosphere, columns, radius, (bounce->radius * bounce->sun_cosine + along * sun_along) / radius, sun);
        pass_step(&place, (float)(length * (end * end - start * start)), left, share);
        for (int w = 0; w < SPECTRUM_COUNT; w++) {
            float scattered = (place.scattered[ATMOSPHERE_AIR][w] + place.scattered[ATMOSPHERE_HAZE][w]) * share[w];
            bounce->second[w] += weight * scattered * sun[w] * (float)(1 / (4 * M_PI));
            bounce->even[w] += weight * scattered;
        }
    }
    if (!meets_ground)
        return;
    double ground_sun = (bounce->radius * bounce->sun_cosine + length * sun_along) / ATMOSPHERE_GROUND;
    find_sun(atmosphere, columns, ATMOSPHERE_GROUND, ground_sun, sun);
    float reflected = (float)(fmax(ground_sun, 0) * bounce->ground / M_PI);
    for (int w = 0; w < SPECTRUM_COUNT; w++)
        bounce->second[w] += weight * left[w] * sun[w] * reflected;
}

/* Directions all round: each stands for as much of the sphere. One half of it is the mirror image of the other. */
static void bounce_at(const struct atmosphere *atmosphere, const struct atmosphere_columns *columns,
                      struct bounce *bounce, float mean[SPECTRUM_COUNT])
{
    enum { ANGLES = 8, TURNS = 4 };
    double sun_sine = sqrt(fmax(1 - bounce->sun_cosine * bounce->sun_cosine, 0));
    for (int a = 0; a < ANGLES; a++) {
        double cosine = 2 * (a + 0.5) / ANGLES - 1, sine = sqrt(1 - cosine * cosine);
        for (int t = 0; t < TURNS; t++) {
            double turn = M_PI * (t + 0.5) / TURNS;
            add_direction(atmosphere, columns, cosine, cosine * bounce->sun_cosine + sine * sun_sine * cos(turn),
                          1.0f / (ANGLES * TURNS), bounce);
        }
    }
    for (int w = 0; w < SPECTRUM_COUNT; w++)
        mean[w] = bounce->second[w] / (1 - fminf(bounce->even[w], 0.99f)); /* and again, and again */
}

void scattering_make(struct scattering *scattering, const struct atmosphere *atmosphere,
                     const struct atmosphere_columns *columns, double ground)
{
#pragma omp parallel for schedule(dynamic) collapse(2)
    for (int h = 0; h < SCATTERING_HEIGHTS; h++) {
        for (int s = 0; s < SCATTERING_SUNS; s++) {
            struct bounce bounce = {.radius = radius_of(h), .sun_cosine = sun_cosine_of(s), .ground = ground};
            bounce_at(atmosphere, columns, &bounce, scattering->mean[h][s]);
        }
    }
}

void scattering_gather(const struct scattering *scattering, const struct atmosphere *atmosphere,
                       const struct atmosphere_columns *columns, const double direction[3], const double sun[3],
                       struct scattering_sum *sum)
{
    const int steps = 32;
    bool meets_ground;
    double length = atmosphere_path(EYE, direction[1], &meets_ground);
    double sun_along = direction[0] * sun[0] + direction[1] * sun[1] + direction[2] * sun[2];
    float left[SPECTRUM_COUNT], share[SPECTRUM_COUNT], light[SPECTRUM_COUNT], mean[SPECTRUM_COUNT];
    *sum = (struct scattering_sum){0};
    for (int w = 0; w < SPECTRUM_COUNT; w++)
        left[w] = 1;
    for (int i = 0; i < steps; i++) {
        double start = (double)i / steps, end = (double)(i + 1) / steps, at = (start + end) / 2;
        double along = length * at * at, radius = sqrt(EYE * EYE + along * along + 2 * EYE * direction[1] * along);
        double sun_cosine = (EYE * sun[1] + along * sun_along) / radius;
        struct place place;
        find_place(atmosphere, radius, &place);
        find_sun(atmosphere, columns, radius, sun_cosine, light);
        look_up(scattering, radius, sun_cosine, mean);
        pass_step(&place, (float)(length * (end * end - start * start)), left, share);
        for (int w = 0; w < SPECTRUM_COUNT; w++) {
            float air = place.scattered[ATMOSPHERE_AIR][w] * share[w];
            float haze = place.scattered[ATMOSPHERE_HAZE][w] * share[w];
            sum->once[ATMOSPHERE_AIR][w] += air * light[w];
            sum->once[ATMOSPHERE_HAZE][w] += haze * light[w];
            sum->more[w] += (air + haze) * mean[w];
        }
    }
}
