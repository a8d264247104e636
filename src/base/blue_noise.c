#include "base/blue_noise.h"

#include "base/random.h"

#include <math.h>

enum { SIDE = BLUE_NOISE_SIDE, COUNT = SIDE * SIDE };

#define SIGMA 1.9 /* texels, of the Gaussians: Ulichney's 1.5 widened for a whole permutation by voids alone */

static void fill_gaussian(float gaussian[COUNT])
{
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            double dx = fmin(x, SIDE - x), dy = fmin(y, SIDE - y);
            gaussian[y * SIDE + x] = (float)exp(-(dx * dx + dy * dy) / (2 * SIGMA * SIGMA));
        }
    }
}

static void add(float energy[COUNT], const float gaussian[COUNT], int place)
{
    int px = place % SIDE, py = place / SIDE;
    for (int y = 0; y < SIDE; y++) {
        const float *row = gaussian + ((y - py + SIDE) % SIDE) * SIDE;
        for (int x = 0; x < SIDE; x++)
            energy[y * SIDE + x] += row[(x - px + SIDE) % SIDE];
    }
}

void blue_noise(int seed, int ranks[COUNT])
{
    float gaussian[COUNT], energy[COUNT];
    fill_gaussian(gaussian);
    for (int i = 0; i < COUNT; i++) {
        energy[i] =
            1e-3f * (float)(random_mix((uint64_t)(i + 1) * 0x9e3779b97f4a7c15u + (uint64_t)seed) >> 40) / (1 << 24);
        ranks[i] = -1;
    }
    for (int rank = 0; rank < COUNT; rank++) {
        int emptiest = -1;
        for (int i = 0; i < COUNT; i++)
            if (ranks[i] < 0 && (emptiest < 0 || energy[i] < energy[emptiest]))
                emptiest = i;
        ranks[emptiest] = rank;
        add(energy, gaussian, emptiest);
    }
}
