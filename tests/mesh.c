/* Meshes from files: every format gives the same tetrahedron, placed, coloured, with normals and cut into triangles. */
#include "support.h"

#include "mesh.h"

/* Reads the bytes as a file of that name. */
static const struct io_mesh *read_as(struct mesh_fixture *fixture, const char *name, const struct mesh_bytes *bytes)
{
    mesh_write(mesh_path(fixture, name), bytes->bytes, bytes->length);
    return mesh_read(fixture);
}

/* Positive where triangles are counter-clockwise as seen from outside. */
static double volume_of(const struct io_mesh *mesh)
{
    double sum = 0;
    for (int i = 0; i < mesh->index_count; i += 3) {
        const float *a = mesh->positions[mesh->indices[i]], *b = mesh->positions[mesh->indices[i + 1]],
                    *c = mesh->positions[mesh->indices[i + 2]];
        sum += (double)(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                        a[2] * (b[0] * c[1] - b[1] * c[0])) /
               6;
    }
    return sum;
}

/* Every corner's normal is that of its triangle: a tetrahedron's faces meet at more than 60°. */
static void expect_flat_normals(const struct io_mesh *mesh)
{
    for (int i = 0; i < mesh->index_count; i++) {
        const float *p[3], *n = mesh->normals[mesh->indices[i]];
        for (int k = 0; k < 3; k++)
            p[k] = mesh->positions[mesh->indices[i / 3 * 3 + k]];
        for (int k = 1; k < 3; k++) {
            float dot = 0;
            for (int c = 0; c < 3; c++)
                dot += (p[k][c] - p[0][c]) * n[c];
            assert_true(fabsf(dot) < 1e-4f);
        }
        assert_true(fabsf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1) < 1e-5f);
    }
}

static void expect_color(const struct io_mesh *mesh, float red, float green, float blue)
{
    for (int v = 0; v < mesh->vertex_count; v++) {
        assert_true(fabsf(mesh->colors[v][0] - red) < 1e-6f);
        assert_true(fabsf(mesh->colors[v][1] - green) < 1e-6f);
        assert_true(fabsf(mesh->colors[v][2] - blue) < 1e-6f);
    }
}

static void all_formats_give_the_same(void **state)
{
    static const float colors[][3] = {{1, 1, 1}, {1, 0.2f, 0},          {1, 0.2f, 0},
                                      {1, 1, 1}, {0.5f, 0.25f, 0.125f}, {0.5f, 0.25f, 0.125f}};
    struct mesh_fixture *fixture = *state;
    for (int i = 0; mesh_names[i]; i++) {
        struct mesh_bytes bytes;
        mesh_sample(&bytes, i);
        const struct io_mesh *mesh = read_as(fixture, mesh_names[i], &bytes);
        assert_int_equal(mesh->index_count, 12);
        assert_int_equal(mesh->vertex_count, 12); /* each corner has three normals */
        assert_true(fabs(volume_of(mesh) - 1.0 / 6) < 1e-6);
        expect_flat_normals(mesh);
        expect_color(mesh, colors[i][0], colors[i][1], colors[i][2]);
    }
    assert_int_equal(fixture->log.errors, 0);
}

static void nodes_place_what_they_hold(void **state)
{
    struct mesh_fixture *fixture = *state;
    struct mesh_bytes bytes = {.length = 0};
    mesh_glb(&bytes, "[{\"children\":[1],\"translation\":[10,0,0]},{\"mesh\":0,\"scale\":[2,2,-2]}]");
    const struct io_mesh *mesh = read_as(fixture, "a.glb", &bytes);
    double sum[3] = {0};
    for (int i = 0; i < mesh->index_count; i++)
        for (int c = 0; c < 3; c++)
            sum[c] += (double)mesh->positions[mesh->indices[i]][c] / mesh->index_count;
    assert_true(fabs(sum[0] - 10.5) < 1e-5);
    assert_true(fabs(sum[1] - 0.5) < 1e-5);
    assert_true(fabs(sum[2] + 0.5) < 1e-5);
    assert_true(fabs(volume_of(mesh) - 8.0 / 6) < 1e-5); /* mirrored, and not inside out */
    expect_flat_normals(mesh);
    for (int i = 9; i < 12; i++) /* the slanted face, which looks away from the mirrored corner */
        assert_true(mesh->normals[mesh->indices[i]][0] > 0.5f && mesh->normals[mesh->indices[i]][2] < -0.5f);
}

static void normals_are_kept_or_made_smooth(void **state)
{
    struct mesh_fixture *fixture = *state;
    /* two squares that meet at 20° in the edge from vertex 2 to vertex 3 */
    const char *roof = "v -1 0 0\nv -1 0 1\nv 0 0 0\nv 0 0 1\nv 1 0.364 0\nv 1 0.364 1\n";
    char text[512];
    snprintf(text, sizeof text, "%sf 1 2 4 3\nf 3 4 6 5\n", roof);
    mesh_write_text(fixture, "a.obj", text);
    const struct io_mesh *mesh = mesh_read(fixture);
    assert_int_equal(mesh->index_count, 12);
    assert_int_equal(mesh->vertex_count, 6);
    for (int v = 0; v < 6; v++) {
        double tilt = -atan2((double)mesh->normals[v][0], (double)mesh->normals[v][1]) * 180 / M_PI;
        double at = (double)mesh->positions[v][0];
        assert_true(fabs(tilt - (at < -0.5 ? 0 : at < 0.5 ? 10 : 20)) < 0.1);
    }
    snprintf(text, sizeof text, "%svn 0.6 0.8 0\nf 1//1 2//1 4//1 3//1\n", roof);
    mesh_write_text(fixture, "a.obj", text);
    mesh = mesh_read(fixture);
    for (int v = 0; v < mesh->vertex_count; v++)
        assert_true(fabsf(mesh->normals[v][0] - 0.6f) < 1e-6f && fabsf(mesh->normals[v][1] - 0.8f) < 1e-6f);
}

/* Triangles of a flat mesh that cover a place, all of them counter-clockwise. */
static int count_covering(const struct io_mesh *mesh, float x, float y)
{
    int count = 0;
    for (int i = 0; i < mesh->index_count; i += 3) {
        int left = 0;
        for (int k = 0; k < 3; k++) {
            const float *p = mesh->positions[mesh->indices[i + k]],
                        *q = mesh->positions[mesh->indices[i + (k + 1) % 3]];
            left += (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]) > 0;
        }
        assert_true(left != 0);
        count += left == 3;
    }
    return count;
}

/* A normal stays square to its surface where a node stretches and mirrors that. */
static void normals_follow_their_nodes(void **state)
{
    static const float numbers[18] = {0,    0, 0,    1,    0, 0,    0,    1, 0, /* corners */
                                      0.6f, 0, 0.8f, 0.6f, 0, 0.8f, 0.6f, 0, 0.8f};
    struct mesh_fixture *fixture = *state;
    mesh_write(mesh_path(fixture, "a.bin"), numbers, sizeof numbers);
    mesh_write_text(
        fixture, "a.gltf",
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
        "\"nodes\":[{\"mesh\":0,\"scale\":[1,1,-2]}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":1}}]}],"
        "\"buffers\":[{\"uri\":\"a.bin\",\"byteLength\":72}],\"bufferViews\":["
        "{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":36}],\"accessors\":["
        "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
        "{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}]}");
    const struct io_mesh *mesh = mesh_read(fixture);
    const double length = sqrt(0.6 * 0.6 + 0.4 * 0.4);
    for (int v = 0; v < 3; v++) {
        assert_true(fabs((double)mesh->normals[v][0] - 0.6 / length) < 1e-6);
        assert_true(fabs((double)mesh->normals[v][2] + 0.4 / length) < 1e-6);
    }
}

/* A comb: its triangles cover back and teeth once, and nothing between the teeth. */
static void hollow_faces_are_cut(void **state)
{
    struct mesh_fixture *fixture = *state;
    char text[2048];
    int length = 0, corners = 0;
    for (int tooth = 0; tooth < 8; tooth++, corners += 4) /* 1 wide, 1 apart; between them the comb is 1 high */
        length += snprintf(text + length, sizeof text - (size_t)length, "v %d 3 0\nv %d 3 0\nv %d 1 0\nv %d 1 0\n",
                           -2 * tooth, -2 * tooth - 1, -2 * tooth - 1, -2 * tooth - 2);
    length += snprintf(text + length, sizeof text - (size_t)length, "v -16 0 0\nv 0 0 0\nf");
    for (int i = 1; i <= corners + 2; i++)
        length += snprintf(text + length, sizeof text - (size_t)length, " %d", i);
    mesh_write_text(fixture, "a.obj", text);
    const struct io_mesh *mesh = mesh_read(fixture);
    assert_int_equal(mesh->index_count, 3 * corners);
    for (int i = 0; i < 16; i++) {
        float x = -0.43f - (float)i;
        assert_int_equal(count_covering(mesh, x, 0.47f), 1);
        for (int j = 0; j < 6; j++)
            assert_int_equal(count_covering(mesh, x, 1.13f + 0.3f * (float)j), i % 2 == 0);
    }
}

/* A square with a notch from above down to near its base: the first corner sticks out and is no ear. */
static void a_corner_with_others_inside_is_no_ear(void **state)
{
    static const float places[][3] = {{0.3f, 9, 1}, {9.7f, 9, 1}, {5, 0.5f, 1}, {1.5f, 8, 0}, {8, 7.9f, 0}, {5, 3, 0}};
    struct mesh_fixture *fixture = *state;
    mesh_write_text(fixture, "a.obj", "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 5 1 0\nv 0 10 0\nf 1 2 3 4 5\n");
    const struct io_mesh *mesh = mesh_read(fixture);
    assert_int_equal(mesh->index_count, 9);
    for (int i = 0; i < 6; i++)
        assert_int_equal(count_covering(mesh, places[i][0], places[i][1]), (int)places[i][2]);
}

static void colors_are_those_of_materials(void **state)
{
    struct mesh_fixture *fixture = *state;
    mesh_write_text(fixture, "a.mtl", "newmtl red\nKd 0.5 0.25 2\nmap_Kd none.png\n");
    mesh_write_text(fixture, "a.obj", "mtllib a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_color(mesh_read(fixture), 0.5f, 0.25f, 1);
    assert_non_null(strstr(fixture->log.text, "textures are not read"));
    mesh_write_text(fixture, "a.obj", "mtllib none.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    mesh_read(fixture);
    assert_non_null(strstr(fixture->log.text, "none.mtl"));
    assert_int_equal(fixture->log.errors, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(all_formats_give_the_same, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(nodes_place_what_they_hold, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(normals_are_kept_or_made_smooth, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(normals_follow_their_nodes, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(hollow_faces_are_cut, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(a_corner_with_others_inside_is_no_ear, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(colors_are_those_of_materials, mesh_setup, mesh_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
