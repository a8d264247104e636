/* A wooden boat, clinker-built: each strake of planks laps over the one below it. Its bottom is painted in the second
 * colour. Inside it has a floor, below which it may lie in the water, and thwarts. */
#include "scene/hull_form.h"
#include "scene/pieces.h"
#include "scene/shape.h"

#include <math.h>

#define STRAKES 9
#define STRAKE_ROWS 5 /* of vertices: close together at the edges, which are rounded */
#define ROWS (STRAKES * STRAKE_ROWS)
#define COLUMNS 81     /* of vertices, from the transom to the stem */
#define BOTTOM 4       /* strakes that are painted in the second colour */
#define LAP 0.008      /* of the breadth: how far a strake stands out where it laps */
#define THICKNESS 0.02 /* of the breadth */
#define TIMBER 0.028   /* of the breadth: radius of keel, stem and edges */
#define FLOOR 0.44     /* of the height */
#define THWART 0.64    /* of the height */
#define THWARTS 3

static const double wood_color[3] = {0.42, 0.26, 0.13};
static const double trim_color[3] = {0.24, 0.12, 0.05};

/* Moved off the surface by `off`, towards the outside, on one half. */
static void point_off(const double size[3], double along, double up, double off, double half, double point[3])
{
    const double step = 1e-3;
    double a = fmin(along, 1 - step), b = fmin(up, 1 - step), p[3], q[3], r[3], normal[3], length = 0;
    hull_point(size, a, b, p);
    hull_point(size, a + step, b, q);
    hull_point(size, a, b + step, r);
    for (int c = 0; c < 3; c++) {
        int d = (c + 1) % 3, e = (c + 2) % 3;
        normal[c] = (q[d] - p[d]) * (r[e] - p[e]) - (q[e] - p[e]) * (r[d] - p[d]);
        length += normal[c] * normal[c];
    }
    hull_point(size, along, up, point);
    for (int c = 0; c < 3 && length > 0; c++)
        point[c] += off * normal[c] / sqrt(length);
    point[2] = half * fmax(point[2], 1e-3 * up * size[2]); /* the halves do not cross */
}

/* A row of vertices along the hull's outside. Where a strake ends and the next begins, the planks lap. */
struct row {
    double up;  /* of the hull's surface */
    double off; /* it, m */
    const double *color;
};

static struct row outside_row(const struct scene_object *object, int j)
{
    static const double shares[STRAKE_ROWS] = {0, 0.12, 0.5, 0.85, 0.97}; /* of the strake's height */
    int strake = j / STRAKE_ROWS;
    double share = j + 1 < ROWS ? shares[j % STRAKE_ROWS] : 1;
    return (struct row){.up = (strake + share) / STRAKES,
                        .off = strake > 0 ? (1 - share) * LAP * object->size[2] : 0,
                        .color = strake < BOTTOM ? object->second_color : object->color};
}

static struct row inside_row(const struct scene_object *object, int j)
{
    return (struct row){.up = 0.02 + 0.98 * j / (ROWS - 1), .off = -THICKNESS * object->size[2], .color = wood_color};
}

/* One half's outside or inside, from the transom to the stem, as one smooth surface: no gaps, and at a lap's edge,
 * where one sees either the plank or what it hides, both look the same. */
static void add_side(struct world_builder *builder, const struct scene_object *object, double half, bool inside)
{
    const double *size = object->size;
    int vertex = builder->vertex_count, index = builder->index_count;
    bool turned = inside == (half > 0);
    for (int j = 0; j < ROWS; j++) {
        const struct row row = inside ? inside_row(object, j) : outside_row(object, j);
        for (int i = 0; i < COLUMNS; i++) {
            double along = (double)(turned ? COLUMNS - 1 - i : i) / (COLUMNS - 1), point[3];
            double ends = fmin(1, (inside ? 0.1 : 0) + 12 * fmin(along, 1 - along));
            point_off(size, along, row.up, row.off * ends, half, point);
            struct world_vertex v = {.place = {(float)(size[0] * along), (float)(0.7 * size[2] * row.up)}};
            for (int c = 0; c < 3; c++) {
                v.position[c] = (float)point[c];
                v.color[c] = (float)row.color[c];
            }
            builder_vertex(builder, &v);
        }
    }
    builder_grid(builder, (unsigned)vertex, COLUMNS, ROWS);
    builder_smooth(builder, vertex, index);
}

/* The flat end at the stern, seen from outside, and `ahead` of that from inside. Its edges have the vertices of the
 * sides; where these meet, the keel covers it. */
static void add_transom(struct world_builder *builder, const struct scene_object *object, double ahead)
{
    const int columns = 9;
    int vertex = builder->vertex_count, index = builder->index_count;
    for (int j = 1; j < ROWS; j++) {
        const struct row row = outside_row(object, j);
        double point[3];
        point_off(object->size, 0, row.up, 0, 1, point);
        for (int i = 0; i < columns; i++) {
            double across = 2.0 * i / (columns - 1) - 1;
            struct world_vertex v = {.place = {(float)(across * point[2]), (float)point[1]}};
            v.position[0] = (float)(point[0] + ahead);
            v.position[1] = (float)point[1];
            v.position[2] = (float)(point[2] * (ahead > 0 ? -across : across));
            for (int c = 0; c < 3; c++)
                v.color[c] = (float)(ahead > 0 ? wood_color : row.color)[c];
            builder_vertex(builder, &v);
        }
    }
    builder_grid(builder, (unsigned)vertex, columns, ROWS - 1);
    builder_smooth(builder, vertex, index);
}

/* Keel and stem, from the stern along the bottom to the top of the bow; then the edges, along both sides. */
static void add_timbers(struct world_builder *builder, const struct scene_object *object, double thick)
{
    double line[COLUMNS + 24][3];
    int points = 0;
    for (int i = 0; i < COLUMNS; i++)
        hull_point(object->size, (double)i / (COLUMNS - 1), 0, line[points++]);
    for (int i = 1; i <= 24; i++)
        hull_point(object->size, 1, i / 24.0, line[points++]);
    piece_tube(builder, (const double(*)[3])line, points, thick, 10, trim_color);
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 0; i < COLUMNS; i++) {
            hull_point(object->size, (double)i / (COLUMNS - 1), 1, line[i]);
            line[i][2] *= side;
        }
        piece_tube(builder, (const double(*)[3])line, COLUMNS, thick, 10, trim_color);
    }
    for (int i = 0; i < 13; i++) { /* along the top of the transom */
        hull_point(object->size, 0, 1, line[i]);
        line[i][2] *= 1 - i / 6.0;
    }
    piece_tube(builder, (const double(*)[3])line, 13, thick, 10, trim_color);
}

/* Boards from side to side, high enough that no water shows above them. */
static void add_floor(struct world_builder *builder, const struct scene_object *object)
{
    const double height = FLOOR * object->size[1], inner = THICKNESS * object->size[2];
    const int columns = 61, rows = 9;
    int vertex = builder->vertex_count, index = builder->index_count;
    for (int j = 0; j < rows; j++) {
        for (int i = 0; i < columns; i++) {
            double across = 1 - 2.0 * j / (rows - 1), point[3];
            hull_point_at(object->size, 0.005 + 0.985 * i / (columns - 1), height, point);
            double side = fmax(point[2] - 0.5 * inner, 0.002) * across;
            struct world_vertex v = {.position = {(float)point[0], (float)height, (float)side},
                                     .color = {(float)wood_color[0], (float)wood_color[1], (float)wood_color[2]},
                                     .place = {(float)point[0], (float)side}};
            builder_vertex(builder, &v);
        }
    }
    builder_grid(builder, (unsigned)vertex, columns, rows);
    builder_smooth(builder, vertex, index);
}

static void add_thwarts(struct world_builder *builder, const struct scene_object *object)
{
    const double *size = object->size, top = THWART * size[1], thick = 0.035 * size[1], wide = 0.05 * size[0];
    for (int t = 0; t < THWARTS; t++) {
        double along = 0.16 + 0.26 * t, middle[3], aft[3], fore[3];
        hull_point_at(size, along, top, middle);
        hull_point_at(size, along - 0.03, top - thick, aft);
        hull_point_at(size, along + 0.03, top - thick, fore);
        double half = fmin(aft[2], fore[2]) - 0.5 * THICKNESS * size[2];
        piece_block(builder, (double[3]){middle[0] - wide / 2, top - thick, -half},
                    (double[3]){middle[0] + wide / 2, top, half}, 0.1, wood_color);
    }
}

static bool build(struct world_builder *builder, const struct scene_object *given, int seed)
{
    (void)seed; /* all boats are alike */
    const double timber = TIMBER * given->size[2], base[3] = {0, timber, 0};
    struct scene_object without = *given; /* what the timbers leave of its size */
    const struct scene_object *object = &without;
    int first = builder->vertex_count;
    for (int c = 0; c < 3; c++)
        without.size[c] = fmax(given->size[c] - 2 * timber, 0.5 * given->size[c]);
    for (int side = 0; side < 4; side++)
        add_side(builder, object, side % 2 ? 1 : -1, side >= 2);
    add_transom(builder, object, 0);
    add_transom(builder, object, THICKNESS * object->size[2]);
    add_timbers(builder, object, timber);
    add_thwarts(builder, object);
    struct world_part boards = piece_material(object, WORLD_PLANKS);
    for (int c = 0; c < 3 && object->pattern == WORLD_PLAIN; c++)
        boards.joint[c] = 0.3 * wood_color[c];
    builder_part(builder, &boards);
    add_floor(builder, object);
    builder_place(builder, first, 0, 0, base);
    return builder_ok(builder);
}

const struct scene_shape shape_hull = {
    .name = "hull",
    .summary = "an open wooden boat, its bow towards +x; size: length, keel to stem, breadth; its floor is at 0.44 of "
               "its height",
    .color = {{0.66, 0.66, 0.62}, {0.3, 0.06, 0.035}},
    .build = build,
};
