#include "scene/hull_form.h"

#include <math.h>

#define WIDEST 0.45  /* along: where the hull is */
#define TRANSOM 0.72 /* its breadth, of the widest */

/* The edge rises to the stem and a little to the stern; a share of the height. */
static double edge_height(double along)
{
    double fore = fmax(along - 0.35, 0) / 0.65, aft = fmax(0.35 - along, 0) / 0.35;
    return 0.74 + 0.26 * fore * fore + 0.07 * aft * aft;
}

/* Half the breadth of the waterline at `up`, a share of the widest: finer bows low down. */
static double plan(double along, double up)
{
    if (along < WIDEST) {
        double aft = (WIDEST - along) / WIDEST;
        return 1 - (1 - TRANSOM) * aft * aft;
    }
    return 1 - pow((along - WIDEST) / (1 - WIDEST), 1.7 + 0.8 * up);
}

void hull_point(const double size[3], double along, double up, double point[3])
{
    /* the stem bends back to the keel, the transom leans back */
    double stem = 0.5 - 0.17 * pow(1 - up, 2.2), stern = -0.5 + 0.05 * (1 - up);
    /* a round bilge amidships, a V at the ends */
    double angle = up * M_PI / 2, ends = fmin(fmax((along - 0.5) / 0.5, 0), 1), aft = fmax(0.4 - along, 0) / 0.4;
    double straight = fmin(0.85 * ends * ends * (3 - 2 * ends) + 0.3 * aft, 1);
    double out = pow(sin(angle), 0.8), high = 1 - pow(cos(angle), 0.8);
    out += straight * (pow(up, 1.15) - out);
    high += straight * (up - high);
    double rocker = 0.035 * (2 * along - 1) * (2 * along - 1);
    point[0] = size[0] * (stern + along * (stem - stern));
    point[1] = size[1] * (rocker + (edge_height(along) - rocker) * high);
    point[2] = size[2] / 2 * plan(along, up) * out;
}

void hull_point_at(const double size[3], double along, double height, double point[3])
{
    double low = 0, high = 1;
    for (int i = 0; i < 30; i++) {
        double middle = (low + high) / 2;
        hull_point(size, along, middle, point);
        *(point[1] < height ? &low : &high) = middle;
    }
    hull_point(size, along, high, point);
}
