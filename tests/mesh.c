/* Meshes from files: every format gives the same tetrahedron, placed, coloured and with normals; what is broken is
 * refused with one error that names the file. */
#include "support.h"

#include "mesh.h"

#include <sys/stat.h>

struct fixture {
    struct support_log log;
    char folder[64], path[512];
    struct io_mesh mesh;
};

static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    support_folder_make(fixture->folder);
    *state = fixture;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *fixture = *state;
    io_mesh_finish(&fixture->mesh);
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

static const char *path_of(struct fixture *fixture, const char *name)
{
    snprintf(fixture->path, sizeof fixture->path, "%s/%s", fixture->folder, name);
    return fixture->path;
}

static void write_text(struct fixture *fixture, const char *name, const char *text)
{
    mesh_write(path_of(fixture, name), text, strlen(text));
}

static const struct io_mesh *read_mesh(struct fixture *fixture)
{
    io_mesh_finish(&fixture->mesh);
    if (!io_mesh_read(fixture->path, &fixture->mesh, &fixture->log.log))
        fail_msg("%s", fixture->log.text);
    return &fixture->mesh;
}

/* Reads the bytes as a file of that name. */
static const struct io_mesh *read_as(struct fixture *fixture, const char *name, const struct mesh_bytes *bytes)
{
    mesh_write(path_of(fixture, name), bytes->bytes, bytes->length);
    return read_mesh(fixture);
}

static void expect_refused(struct fixture *fixture, enum dpl_reason reason, const char *part)
{
    io_mesh_finish(&fixture->mesh);
    if (io_mesh_read(fixture->path, &fixture->mesh, &fixture->log.log))
        fail_msg("read: %s", fixture->path);
    EXPECT_ERROR(&fixture->log, reason, fixture->path, part);
    assert_null(fixture->mesh.positions);
    assert_null(fixture->mesh.indices);
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
    struct fixture *fixture = *state;
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
    struct fixture *fixture = *state;
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
    struct fixture *fixture = *state;
    /* two squares that meet at 20° in the edge from vertex 2 to vertex 3 */
    const char *roof = "v -1 0 0\nv -1 0 1\nv 0 0 0\nv 0 0 1\nv 1 0.364 0\nv 1 0.364 1\n";
    char text[512];
    snprintf(text, sizeof text, "%sf 1 2 4 3\nf 3 4 6 5\n", roof);
    write_text(fixture, "a.obj", text);
    const struct io_mesh *mesh = read_mesh(fixture);
    assert_int_equal(mesh->index_count, 12);
    assert_int_equal(mesh->vertex_count, 6);
    for (int v = 0; v < 6; v++) {
        double tilt = -atan2((double)mesh->normals[v][0], (double)mesh->normals[v][1]) * 180 / M_PI;
        double at = (double)mesh->positions[v][0];
        assert_true(fabs(tilt - (at < -0.5 ? 0 : at < 0.5 ? 10 : 20)) < 0.1);
    }
    snprintf(text, sizeof text, "%svn 0.6 0.8 0\nf 1//1 2//1 4//1 3//1\n", roof);
    write_text(fixture, "a.obj", text);
    mesh = read_mesh(fixture);
    for (int v = 0; v < mesh->vertex_count; v++)
        assert_true(fabsf(mesh->normals[v][0] - 0.6f) < 1e-6f && fabsf(mesh->normals[v][1] - 0.8f) < 1e-6f);
}

static void colors_are_those_of_materials(void **state)
{
    struct fixture *fixture = *state;
    write_text(fixture, "a.mtl", "newmtl red\nKd 0.5 0.25 2\nmap_Kd none.png\n");
    write_text(fixture, "a.obj", "mtllib a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect_color(read_mesh(fixture), 0.5f, 0.25f, 1);
    assert_non_null(strstr(fixture->log.text, "textures are not read"));
    write_text(fixture, "a.obj", "mtllib none.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    read_mesh(fixture);
    assert_non_null(strstr(fixture->log.text, "none.mtl"));
    assert_int_equal(fixture->log.errors, 0);
}

static void files_beside_it_are_read_and_no_others(void **state)
{
    static const char *const outside[] = {"../a.bin", "folder/../../a.bin", "none.bin", "%2e%2e/a.bin", NULL};
    struct fixture *fixture = *state;
    struct mesh_bytes bytes = {.length = 0};
    char folder[128], uri[256];
    mesh_add(&bytes, mesh_corners, 48);
    mesh_add(&bytes, mesh_faces, 12);
    mesh_write(path_of(fixture, "a.bin"), bytes.bytes, bytes.length);
    bytes.length = 0;
    mesh_gltf(&bytes, "\"uri\":\"a.bin\",", "[{\"mesh\":0}]");
    assert_true(fabs(volume_of(read_as(fixture, "a.gltf", &bytes)) - 1.0 / 6) < 1e-6);
    snprintf(folder, sizeof folder, "%s/inner", fixture->folder);
    assert_int_equal(mkdir(folder, 0777), 0);
    for (int i = 0; i <= 4; i++) {
        snprintf(uri, sizeof uri, i < 4 ? "\"uri\":\"%s\"," : "\"uri\":\"%.0s%s/a.bin\",", i < 4 ? outside[i] : "",
                 fixture->folder);
        bytes.length = 0;
        mesh_gltf(&bytes, uri, "[{\"mesh\":0}]");
        mesh_write(path_of(fixture, "inner/a.gltf"), bytes.bytes, bytes.length);
        expect_refused(fixture, DPL_REASON_FILE_READ, "in its folder");
    }
    unlink(fixture->path);
}

static void broken_text_is_refused(void **state)
{
    static const struct {
        const char *name, *text;
        enum dpl_reason reason;
        const char *part;
    } cases[] = {
        {"a.obj", "", DPL_REASON_FILE_FORMAT, "empty"},
        {"a.obj", "hello\n", DPL_REASON_FILE_FORMAT, "no OBJ"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", DPL_REASON_FILE_FORMAT, "no triangles"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\n", DPL_REASON_FILE_FORMAT, "no triangles"},
        {"a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", DPL_REASON_RANGE, "vertex 0: nan"},
        {"a.obj", "v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n", DPL_REASON_RANGE, "vertex 1: inf"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 -1000001 0\nf 1 2 3\n", DPL_REASON_RANGE, "-1e+06"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", DPL_REASON_FILE_FORMAT, "out of range"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", DPL_REASON_FILE_FORMAT, "out of range"},
        {"a.ply", "ply\n", DPL_REASON_FILE_FORMAT, "no PLY"},
        {"a.stl", "solid x\n", DPL_REASON_FILE_FORMAT, "no STL"},
        {"a.glb", "glTF", DPL_REASON_FILE_FORMAT, "no GLB"},
        {"a.gltf", "[]", DPL_REASON_FILE_FORMAT, "no glTF"},
        {"a.gltf", "{}", DPL_REASON_FILE_FORMAT, "cannot be read"},
        {"a.jpg", "x", DPL_REASON_FILE_FORMAT, ".obj, .gltf, .glb, .ply, .stl"},
        {"obj", "x", DPL_REASON_FILE_FORMAT, "ending"},
    };
    struct fixture *fixture = *state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        write_text(fixture, cases[i].name, cases[i].text);
        expect_refused(fixture, cases[i].reason, cases[i].part);
    }
}

static void counts_beyond_the_file_are_refused(void **state)
{
    static const char *const changes[][2] = {{"vertex 4", "vertex 4000000000"},
                                             {"vertex 4", "vertex -4"},
                                             {"face 4", "face 5"},
                                             {"3 0 2 1", "3 0 2 9"},
                                             {"uchar int", "uchar none"}};
    struct fixture *fixture = *state;
    for (int i = 0; i < 5; i++) {
        struct mesh_bytes bytes, changed = {.length = 0};
        mesh_sample(&bytes, 1);
        bytes.bytes[bytes.length] = '\0';
        char *place = strstr(bytes.bytes, changes[i][0]);
        assert_non_null(place);
        mesh_add(&changed, bytes.bytes, (size_t)(place - bytes.bytes));
        mesh_print(&changed, "%s%s", changes[i][1], place + strlen(changes[i][0]));
        mesh_write(path_of(fixture, "a.ply"), changed.bytes, changed.length);
        expect_refused(fixture, DPL_REASON_FILE_FORMAT, "");
    }
}

/* What would be followed for ever, too deep, or again and again. */
static void nodes_that_are_no_trees_are_refused(void **state)
{
    static const char *const nodes[] = {
        "[{\"mesh\":0,\"children\":[0]}]", "[{\"mesh\":0,\"children\":[1]},{\"children\":[0]}]",
        "[{\"children\":[1,1]},{\"mesh\":0}]", "[{\"children\":[1,2]},{\"children\":[2]},{\"mesh\":0}]",
        "[{\"child\\u0072en\":[1,1]},{\"mesh\":0}]"};
    struct fixture *fixture = *state;
    for (int i = 0; i < 5; i++) {
        struct mesh_bytes bytes = {.length = 0};
        mesh_gltf(&bytes, mesh_data, nodes[i]);
        mesh_write(path_of(fixture, "a.gltf"), bytes.bytes, bytes.length);
        expect_refused(fixture, DPL_REASON_FILE_FORMAT, "tree");
    }
    char *deep = malloc(1000000);
    memset(deep, '[', 1000000);
    memcpy(deep, "{\"a\":", 5);
    mesh_write(path_of(fixture, "a.gltf"), deep, 1000000);
    free(deep);
    expect_refused(fixture, DPL_REASON_FILE_FORMAT, "64 brackets");
}

/* 40 000 triangles in a hundred and one places. */
static void too_many_triangles_are_refused(void **state)
{
    struct fixture *fixture = *state;
    char *bytes = calloc(1, 36 + 120000), text[8192];
    for (int i = 0; i < 40000; i++)
        memcpy(bytes + 36 + 3 * i, "\0\1\2", 3);
    memcpy(bytes, mesh_corners, 36);
    mesh_write(path_of(fixture, "a.bin"), bytes, 36 + 120000);
    free(bytes);
    int length = snprintf(text, sizeof text,
                          "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
                          "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
                          "\"buffers\":[{\"uri\":\"a.bin\",\"byteLength\":120036}],"
                          "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},"
                          "{\"buffer\":0,\"byteOffset\":36,\"byteLength\":120000}],\"accessors\":["
                          "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
                          "{\"bufferView\":1,\"componentType\":5121,\"count\":120000,\"type\":\"SCALAR\"}],"
                          "\"nodes\":[{\"children\":[1");
    for (int i = 2; i <= 101; i++)
        length += snprintf(text + length, sizeof text - (size_t)length, ",%d", i);
    length += snprintf(text + length, sizeof text - (size_t)length, "]}");
    for (int i = 1; i <= 101; i++)
        length += snprintf(text + length, sizeof text - (size_t)length, ",{\"mesh\":0}");
    snprintf(text + length, sizeof text - (size_t)length, "]}");
    write_text(fixture, "a.gltf", text);
    expect_refused(fixture, DPL_REASON_LIMIT, "4000000");
}

static void what_is_no_file_is_refused(void **state)
{
    struct fixture *fixture = *state;
    path_of(fixture, "none.obj");
    expect_refused(fixture, DPL_REASON_FILE_READ, "No such file");
    assert_int_equal(mkdir(path_of(fixture, "folder.obj"), 0777), 0);
    expect_refused(fixture, DPL_REASON_FILE_READ, "regular file");
    write_text(fixture, "huge.obj", "v");
    assert_int_equal(truncate(fixture->path, (off_t)257 << 20), 0);
    expect_refused(fixture, DPL_REASON_FILE_READ, "too large");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(all_formats_give_the_same, setup, teardown),
        cmocka_unit_test_setup_teardown(nodes_place_what_they_hold, setup, teardown),
        cmocka_unit_test_setup_teardown(normals_are_kept_or_made_smooth, setup, teardown),
        cmocka_unit_test_setup_teardown(colors_are_those_of_materials, setup, teardown),
        cmocka_unit_test_setup_teardown(files_beside_it_are_read_and_no_others, setup, teardown),
        cmocka_unit_test_setup_teardown(broken_text_is_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(counts_beyond_the_file_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(nodes_that_are_no_trees_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(too_many_triangles_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(what_is_no_file_is_refused, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
