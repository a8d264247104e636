#include "reference/photon_tree.h"

#define ALONE 4096 /* photons that one thread orders by itself */

static void swap(struct photon *a, struct photon *b)
{
    struct photon kept = *a;
    *a = *b;
    *b = kept;
}

static float middle_of(float a, float b, float c)
{
    float low = a < b ? a : b, high = a < b ? b : a;
    return c < low ? low : c > high ? high : c;
}

/* Puts the photon there that belongs there along the axis, smaller ones before it (Hoare 1961, FIND). */
static void select_at(struct photon *photons, int first, int last, int wanted, int axis)
{
    while (first < last) {
        float pivot = middle_of(photons[first].position[axis], photons[(first + last) / 2].position[axis],
                                photons[last].position[axis]);
        int i = first, j = last;
        while (i <= j) {
            while (photons[i].position[axis] < pivot)
                i++;
            while (photons[j].position[axis] > pivot)
                j--;
            if (i <= j)
                swap(photons + i++, photons + j--);
        }
        if (j < wanted)
            first = i;
        if (wanted < i)
            last = j;
    }
}

static int widest_axis(const struct photon *photons, int first, int last)
{
    float low[3], high[3];
    for (int c = 0; c < 3; c++)
        low[c] = high[c] = photons[first].position[c];
    for (int i = first + 1; i <= last; i++) {
        for (int c = 0; c < 3; c++) {
            float at = photons[i].position[c];
            low[c] = at < low[c] ? at : low[c];
            high[c] = at > high[c] ? at : high[c];
        }
    }
    int axis = 0;
    for (int c = 1; c < 3; c++)
        axis = high[c] - low[c] > high[axis] - low[axis] ? c : axis;
    return axis;
}

/* From `first` to `last`: the middle one divides the others. */
static void order(struct photon_tree *tree, int first, int last)
{
    while (first < last) {
        int middle = first + (last - first) / 2, axis = widest_axis(tree->photons, first, last);
        select_at(tree->photons, first, last, middle, axis);
        tree->axes[middle] = (unsigned char)axis;
#pragma omp task if (last - first > ALONE)
        order(tree, first, middle - 1);
        first = middle + 1;
    }
}

void photon_tree_build(struct photon_tree *tree)
{
#pragma omp parallel
#pragma omp single
    order(tree, 0, tree->count - 1);
}

/* A search on its way. */
struct search {
    const struct photon_tree *tree;
    const double *place;
    double radius;
    void (*visit)(void *user, const struct photon *photon);
    void *user;
};

static void look_at(const struct search *search, const struct photon *photon)
{
    double square = 0;
    for (int c = 0; c < 3; c++) {
        double away = (double)photon->position[c] - search->place[c];
        square += away * away;
    }
    if (square < search->radius * search->radius)
        search->visit(search->user, photon);
}

static void search_part(const struct search *search, int first, int last)
{
    while (first <= last) {
        int middle = first + (last - first) / 2, axis = first < last ? search->tree->axes[middle] : 0;
        const struct photon *photon = search->tree->photons + middle;
        double away = search->place[axis] - (double)photon->position[axis];
        look_at(search, photon);
        if (away > search->radius) {
            first = middle + 1;
        } else if (away < -search->radius) {
            last = middle - 1;
        } else {
            search_part(search, first, middle - 1);
            first = middle + 1;
        }
    }
}

void photon_tree_visit(const struct photon_tree *tree, const double place[3], double radius,
                       void (*visit)(void *user, const struct photon *photon), void *user)
{
    const struct search search = {tree, place, radius, visit, user};
    search_part(&search, 0, tree->count - 1);
}
