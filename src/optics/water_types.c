#include "optics/water_types.h"

#include <assert.h>
#include <math.h>
#include <stddef.h>

/* Absorption and scattering coefficients, 1/m, at 625, 550 and 450 nm.
 *
 * Pure water: absorption by Pope & Fry 1997, scattering by Morel 1974.
 *
 * A type of Jerlov's is defined by how fast daylight fades with depth, K: Austin & Petzold 1984 for the oceanic types
 * and the first coastal one, Jerlov 1976 (table XXVII) for the others. Scattering is that of Solonenko & Mobley 2015.
 * Absorption is what then gives K by Kirk 1984 with the sun overhead, K² = a² + 0.235 a b, and never less than that
 * of pure water. (The absorption printed in 2015 gives a K up to two fifths lower.) */
struct water_type {
    const char *name;
    double absorption[3], scattering[3];
};
static const struct water_type types[] = {
    {"custom", {0}, {0}},
    {"pure", {0.2834, 0.0565, 0.00922}, {0.0008, 0.0015, 0.0035}},
    {"oceanic-I", {0.317, 0.0638, 0.0171}, {0.0013, 0.002, 0.004}},
    {"oceanic-IA", {0.320, 0.0669, 0.0249}, {0.0028, 0.004, 0.007}},
    {"oceanic-IB", {0.319, 0.0654, 0.0282}, {0.046, 0.054, 0.070}},
    {"oceanic-II", {0.306, 0.0565, 0.0330}, {0.293, 0.365, 0.516}},
    {"oceanic-III", {0.2834, 0.0565, 0.0499}, {0.800, 0.998, 1.413}},
    {"coastal-1", {0.359, 0.104, 0.152}, {0.298, 0.372, 0.526}},
    {"coastal-3", {0.312, 0.102, 0.250}, {0.853, 1.071, 1.532}},
    {"coastal-5", {0.364, 0.179, 0.383}, {1.145, 1.382, 1.857}},
    {"coastal-7", {0.359, 0.258, 0.578}, {1.923, 2.394, 3.376}},
    {"coastal-9", {0.416, 0.359, 1.157}, {2.551, 3.180, 4.496}},
};
enum { TYPE_COUNT = sizeof types / sizeof *types, PURE = 1 };

const char *optics_water_type_name(int i)
{
    return i >= 0 && i < TYPE_COUNT ? types[i].name : NULL;
}

struct optics_water optics_water_type(int type, double anisotropy)
{
    const int green = 1;
    assert(type > OPTICS_WATER_CUSTOM && type < TYPE_COUNT);
    struct optics_water water = {0};
    for (int c = 0; c < 3; c++) {
        water.absorption[c] = types[type].absorption[c];
        water.scattering[c] = types[type].scattering[c];
    }
    water.anisotropy = anisotropy * fmax(1 - types[PURE].scattering[green] / water.scattering[green], 0);
    return water;
}
