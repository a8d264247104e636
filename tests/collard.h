/* tests/collard.h: the waves and the caustic map of Collard & Mundi 2022 a second time, as plain as can be, in double
 * precision, for the library to be held against. Shares no code with it. */
#ifndef TESTS_COLLARD_H
#define TESTS_COLLARD_H

#include <math.h>
#include <stdlib.h>

#define COLLARD_CELLS 160
#define COLLARD_SIDE (COLLARD_CELLS + 1)

/* The four presets of the paper's program. */
struct collard_preset {
    double amplitude, frequency, depth, base_intensity;
    int steps;
    double sun_exponent;
};
static const struct collard_preset collard_presets[] = {
    {0.06125, 4, 1, 0.6, 3, 256}, {0.02, 7, 0.4, 0.5, 4, 256}, {0.033, 8, 1, 0.3, 5, 32}, {0.2, 2, 1, 0.4, 5, 256}};

/* The number of each vertex in the paper's mesh file, [row][column], rows from -z to +z, in the order of that file. */
static inline void collard_numbers(int numbers[COLLARD_SIDE][COLLARD_SIDE])
{
    const int n = COLLARD_CELLS;
    int next = 0;
    numbers[n][0] = next++;
    numbers[n][n] = next++;
    numbers[0][0] = next++;
    numbers[0][n] = next++;
    for (int i = 1; i < n; i++)
        numbers[n][i] = next++;
    for (int i = n - 1; i > 0; i--)
        numbers[0][i] = next++;
    for (int j = 1; j < n; j++)
        numbers[j][0] = next++;
    for (int j = n - 1; j > 0; j--)
        numbers[j][n] = next++;
    for (int i = 1; i < n; i++)
        for (int j = n - 1; j > 0; j--)
            numbers[j][i] = next++;
}

/* Height of preset 1 to 4 at a vertex. */
static inline double collard_height(int preset, double A, double f, double x, double z, int number, double t)
{
    const double P = 3.14159, phi = 1.618034, E = 2.7182818, d = sqrt(x * x + z * z);
    double fine = sin(-5 * P * d * f + 2 * t), swell, crossing;
    swell = A * sin(-P * x * f / 16 + 2 * t) + A * sin(-P * x * z * f / 8 + 2 * t);
    crossing = A / 1.5 * sin(-P * d * f + 2 * t) * sin(-P * x * f + 3 * t) * sin(-P * z * f / 2 + 4 * t);
    /* the program's angle: single precision, each product rounded */
    volatile float angle = -(float)P;
    angle *= (float)x;
    angle *= (float)f;
    angle *= (float)(4 * number);
    switch (preset) {
    case 1:
        return A / 10 * 0.2 *
                   (-3.2 * sin(-1.3 * phi * (1 - d / 2) * (t + 30000) * 4) - 1.2 * sin(-1.7 * E * z * t) +
                    1.9 * sin(1.7 * P * x * (t + 30000))) +
               A / 50 * fine;
    case 2:
        return crossing * (sin((double)angle + 2 * t) + 1) / 2 + swell + A / 10 * fine;
    case 3:
        return swell + A / 50 * fine + crossing;
    default:
        return A / 10 * sin(-P * d * f + t);
    }
}

/* Adds the unit normal of triangle a b c to the sums of its corners. Points are x, height, z. */
static inline void collard_add_triangle(double (*points)[3], double (*sums)[3], int a, int b, int c)
{
    double u[3], v[3], n[3];
    for (int k = 0; k < 3; k++) {
        u[k] = points[b][k] - points[a][k];
        v[k] = points[c][k] - points[a][k];
    }
    n[0] = u[1] * v[2] - u[2] * v[1];
    n[1] = u[2] * v[0] - u[0] * v[2];
    n[2] = u[0] * v[1] - u[1] * v[0];
    double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) * (n[1] < 0 ? -1 : 1);
    for (int k = 0; k < 3; k++) {
        sums[a][k] += n[k] / length;
        sums[b][k] += n[k] / length;
        sums[c][k] += n[k] / length;
    }
}

/* Unit normals of all vertices: sums of the unit normals of the triangles around, normalised. `heights` row by row from
 * -z, on a square of that size. */
static inline void collard_normals(const double *heights, double size, double (*normals)[3])
{
    const int n = COLLARD_SIDE;
    double(*points)[3] = calloc((size_t)(n * n), sizeof *points);
    for (int i = 0; i < n * n; i++) {
        points[i][0] = i % n * size / COLLARD_CELLS;
        points[i][1] = heights[i];
        points[i][2] = i / n * size / COLLARD_CELLS;
        normals[i][0] = normals[i][1] = normals[i][2] = 0;
    }
    for (int j = 0; j + 1 < n; j++) {
        for (int i = 0; i + 1 < n; i++) {
            int here = j * n + i; /* the cut from here + 1 to here + n has dx and dz of opposite signs */
            collard_add_triangle(points, normals, here, here + 1, here + n);
            collard_add_triangle(points, normals, here + 1, here + n, here + n + 1);
        }
    }
    for (int i = 0; i < n * n; i++) {
        double *normal = normals[i];
        double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        for (int k = 0; k < 3; k++)
            normal[k] /= length;
    }
    free(points);
}

/* All heights of a preset with those values, row by row from -z. */
static inline void collard_heights(int preset, double amplitude, double frequency, double time, double *heights)
{
    static int numbers[COLLARD_SIDE][COLLARD_SIDE];
    collard_numbers(numbers);
    for (int j = 0; j < COLLARD_SIDE; j++)
        for (int i = 0; i < COLLARD_SIDE; i++)
            heights[j * COLLARD_SIDE + i] =
                collard_height(preset, amplitude, frequency, -2 + 0.025 * i, -2 + 0.025 * j, numbers[j][i], time);
}

#endif
