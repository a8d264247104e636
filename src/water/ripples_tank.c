/* Evan Wallace's water (2011), the height field of Matthias Müller ("Fast water simulation for games using height
 * fields", GDC 2008): the wave equation by the least of explicit schemes.
 *
 *     v ← d (v + 2 (mean of the four neighbours - h)),   h ← h + v
 *
 * That is a Courant number c Δt / Δx of √½, the largest at which it is stable, and where waves along the diagonal go at
 * exactly their speed. A neighbour beyond the edge is the vertex itself: a wall half a cell outside, which reflects.
 *
 * With A = 2 (1 - mean of neighbours), a symmetric matrix whose eigenvalues λ are those of a membrane with free edges,
 * 0 ≤ λ < 4, an eigenvector's share x of h goes from step to step as x₂ = (1 + d - d λ) x₁ - d x₀. The roots of
 * r² - (1 + d - d λ) r + d have the product d, so that (x₁ - r x₀) (x₁ - s x₀), r and s the roots, shrinks by just d a
 * step, and with it the sum over all eigenvectors, with h before a step and v after it
 *
 *     E = ½ (⟨v, v⟩ + (1 - d) ⟨h, v⟩ + d ⟨h, A (h + v)⟩)
 *
 * which without damping is kinetic and potential energy, and stays. It is positive for every wave that swings (complex
 * roots), so no wave grows. */
#include "water/ripples_tank.h"

#include "base/log.h"
#include "base/vector.h"

#include <math.h>
#include <stdlib.h>

#define ALONE_MAX 512 /* vertices a side; in smaller tanks threads wait for each other longer than they work */

bool tank_resize(struct tank *tank, int side, const struct dpl_log *log)
{
    if (tank->heights && tank->side == side)
        return true;
    tank_finish(tank);
    size_t count = (size_t)side * (size_t)side;
    tank->heights = base_allocate(log, count, sizeof(float), "ripples");
    tank->speeds = base_allocate(log, count, sizeof(float), "ripples");
    tank->side = side;
    if (tank->heights && tank->speeds)
        return true;
    tank_finish(tank);
    return false;
}

void tank_finish(struct tank *tank)
{
    free(tank->heights);
    free(tank->speeds);
    *tank = (struct tank){0};
}

void tank_calm(struct tank *tank, float height)
{
    for (size_t i = 0; i < (size_t)tank->side * (size_t)tank->side; i++) {
        tank->heights[i] = height;
        tank->speeds[i] = 0;
    }
}

float tank_level(const struct tank *tank)
{
    size_t count = (size_t)tank->side * (size_t)tank->side;
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)tank->heights[i];
    return (float)(sum / (double)count);
}

VECTOR_PART float accelerate(float damping, float speed, float height, float along, float across)
{
    return damping * (speed + (0.5f * (along + across) - 2 * height));
}

VECTOR_CLONES static void accelerate_row(int side, float damping, const float *restrict above,
                                         const float *restrict row, const float *restrict below, float *restrict speeds)
{
    const int last = side - 1;
    for (int i = 1; i < last; i++)
        speeds[i] = accelerate(damping, speeds[i], row[i], row[i - 1] + row[i + 1], above[i] + below[i]);
    speeds[0] = accelerate(damping, speeds[0], row[0], row[0] + row[1], above[0] + below[0]);
    speeds[last] = accelerate(damping, speeds[last], row[last], row[last - 1] + row[last], above[last] + below[last]);
}

VECTOR_CLONES static void move_row(int side, const float *restrict speeds, float *restrict row)
{
    for (int i = 0; i < side; i++)
        row[i] += speeds[i];
}

static void step(struct tank *tank)
{
    const int side = tank->side, last = side - 1;
    const float damping = (float)tank->damping;
    float *heights = tank->heights, *speeds = tank->speeds;
#pragma omp parallel if (side > ALONE_MAX)
    {
#pragma omp for
        for (int j = 0; j < side; j++) {
            const float *row = heights + (size_t)j * (size_t)side;
            accelerate_row(side, damping, j > 0 ? row - side : row, row, j < last ? row + side : row,
                           speeds + (size_t)j * (size_t)side);
        }
#pragma omp for
        for (int j = 0; j < side; j++)
            move_row(side, speeds + (size_t)j * (size_t)side, heights + (size_t)j * (size_t)side);
    }
}

static double place(const struct tank *tank, int vertex)
{
    return vertex * tank->spacing - tank->pool.half;
}

/* The vertices from `low` to `high` metres along an axis. */
struct range {
    int first, end;
};
static struct range range_of(const struct tank *tank, double low, double high)
{
    double first = ceil((low + tank->pool.half) / tank->spacing),
           last = floor((high + tank->pool.half) / tank->spacing);
    return (struct range){(int)fmin(fmax(first, 0), tank->side), (int)fmin(fmax(last + 1, 0), tank->side)};
}

static void add_drop(struct tank *tank, const struct water_drop *drop)
{
    struct range columns = range_of(tank, drop->x - drop->radius, drop->x + drop->radius);
    struct range rows = range_of(tank, drop->z - drop->radius, drop->z + drop->radius);
    for (int j = rows.first; j < rows.end; j++) {
        float *row = tank->heights + (size_t)j * (size_t)tank->side;
        for (int i = columns.first; i < columns.end; i++) {
            double distance = hypot(place(tank, i) - drop->x, place(tank, j) - drop->z);
            double w = fmax(0, 1 - distance / drop->radius);
            row[i] += (float)(drop->height * (0.5 - 0.5 * cos(M_PI * w)));
        }
    }
}

static void displace(struct tank *tank, const struct ball *from, const struct ball *to)
{
    struct range ranges[2];
    for (int a = 0; a < 2; a++)
        ranges[a] = range_of(tank, fmin(from->center[2 * a] - ball_reach(from), to->center[2 * a] - ball_reach(to)),
                             fmax(from->center[2 * a] + ball_reach(from), to->center[2 * a] + ball_reach(to)));
#pragma omp parallel for if (tank->side > ALONE_MAX)
    for (int j = ranges[1].first; j < ranges[1].end; j++) {
        float *row = tank->heights + (size_t)j * (size_t)tank->side;
        for (int i = ranges[0].first; i < ranges[0].end; i++) {
            double x = place(tank, i), z = place(tank, j);
            row[i] += ball_volume(from, &tank->pool, x, z) - ball_volume(to, &tank->pool, x, z);
        }
    }
}

void tank_apply(struct tank *tank, const struct ripples_event *event)
{
    if (event->kind == RIPPLES_STEP)
        step(tank);
    else if (event->kind == RIPPLES_DROP)
        add_drop(tank, &event->drop);
    else
        displace(tank, &event->from, &event->to);
}
