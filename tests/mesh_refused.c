/* Meshes from files that are broken, or that ask for too much: each is refused with one error that names the file. */
#include "support.h"

#include "mesh.h"

#include <sys/stat.h>

static void expect_refused(struct mesh_fixture *fixture, enum dpl_reason reason, const char *part)
{
    io_mesh_finish(&fixture->mesh);
    if (io_mesh_read(fixture->path, &fixture->mesh, &fixture->log.log))
        fail_msg("read: %s", fixture->path);
    EXPECT_ERROR(&fixture->log, reason, fixture->path, part);
    assert_null(fixture->mesh.positions);
    assert_null(fixture->mesh.indices);
}

static void files_beside_it_are_read_and_no_others(void **state)
{
    static const char *const outside[] = {"../a.bin", "folder/../../a.bin", "none.bin", "%2e%2e/a.bin", NULL};
    struct mesh_fixture *fixture = *state;
    struct mesh_bytes bytes = {.length = 0};
    char folder[128], uri[256];
    mesh_add(&bytes, mesh_corners, 48);
    mesh_add(&bytes, mesh_faces, 12);
    mesh_write(mesh_path(fixture, "a.bin"), bytes.bytes, bytes.length);
    bytes.length = 0;
    mesh_gltf(&bytes, "\"uri\":\"a.bin\",", "[{\"mesh\":0}]");
    mesh_write(mesh_path(fixture, "a.gltf"), bytes.bytes, bytes.length);
    assert_int_equal(mesh_read(fixture)->index_count, 12);
    snprintf(folder, sizeof folder, "%s/inner", fixture->folder);
    assert_int_equal(mkdir(folder, 0777), 0);
    for (int i = 0; i <= 4; i++) {
        snprintf(uri, sizeof uri, i < 4 ? "\"uri\":\"%s\"," : "\"uri\":\"%.0s%s/a.bin\",", i < 4 ? outside[i] : "",
                 fixture->folder);
        bytes.length = 0;
        mesh_gltf(&bytes, uri, "[{\"mesh\":0}]");
        mesh_write(mesh_path(fixture, "inner/a.gltf"), bytes.bytes, bytes.length);
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
    struct mesh_fixture *fixture = *state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mesh_write_text(fixture, cases[i].name, cases[i].text);
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
    struct mesh_fixture *fixture = *state;
    for (int i = 0; i < 5; i++) {
        struct mesh_bytes bytes, changed = {.length = 0};
        mesh_sample(&bytes, 1);
        bytes.bytes[bytes.length] = '\0';
        char *place = strstr(bytes.bytes, changes[i][0]);
        assert_non_null(place);
        mesh_add(&changed, bytes.bytes, (size_t)(place - bytes.bytes));
        mesh_print(&changed, "%s%s", changes[i][1], place + strlen(changes[i][0]));
        mesh_write(mesh_path(fixture, "a.ply"), changed.bytes, changed.length);
        expect_refused(fixture, DPL_REASON_FILE_FORMAT, "");
    }
}

/* What would take for ever: each kind of element reads the header again. */
static void too_many_elements_are_refused(void **state)
{
    struct mesh_fixture *fixture = *state;
    struct mesh_bytes bytes = {.length = 0};
    mesh_print(&bytes, "ply\nformat ascii 1.0\n");
    for (int i = 0; i < 17; i++)
        mesh_print(&bytes, "element a 0\n");
    mesh_print(&bytes, "end_header\n");
    mesh_write(mesh_path(fixture, "a.ply"), bytes.bytes, bytes.length);
    expect_refused(fixture, DPL_REASON_FILE_FORMAT, "16 elements");
}

/* One triangle of a mesh with many vertices, placed often. */
static void vertices_placed_too_often_are_refused(void **state)
{
    enum { VERTICES = 100000, NODES = 200 };
    struct mesh_fixture *fixture = *state;
    static char text[NODES * 16 + 1000], bytes[VERTICES * 12 + 6] = {0};
    const unsigned char face[6] = {0, 0, 1, 0, 2, 0};
    int used = snprintf(
        text, sizeof text,
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"buffers\":[{\"uri\":\"a.bin\",\"byteLength\":%d}],"
        "\"bufferViews\":[{\"buffer\":0,\"byteLength\":%d},{\"buffer\":0,\"byteOffset\":%d,\"byteLength\":6}],"
        "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%d,\"type\":\"VEC3\"},"
        "{\"bufferView\":1,\"componentType\":5123,\"count\":3,\"type\":\"SCALAR\"}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],\"nodes\":[{\"mesh\":0}",
        VERTICES * 12 + 6, VERTICES * 12, VERTICES * 12, VERTICES);
    for (int i = 1; i < NODES; i++)
        used += snprintf(text + used, sizeof text - (size_t)used, ",{\"mesh\":0}");
    used += snprintf(text + used, sizeof text - (size_t)used, "],\"scenes\":[{\"nodes\":[0");
    for (int i = 1; i < NODES; i++)
        used += snprintf(text + used, sizeof text - (size_t)used, ",%d", i);
    used += snprintf(text + used, sizeof text - (size_t)used, "]}]}");
    memcpy(bytes + VERTICES * 12, face, sizeof face);
    mesh_write(mesh_path(fixture, "a.bin"), bytes, sizeof bytes);
    mesh_write(mesh_path(fixture, "a.gltf"), text, (size_t)used);
    expect_refused(fixture, DPL_REASON_LIMIT, "too many vertices");
}

/* What would be followed for ever, too deep, or again and again. */
static void nodes_that_are_no_trees_are_refused(void **state)
{
    static const char *const nodes[] = {
        "[{\"mesh\":0,\"children\":[0]}]", "[{\"mesh\":0,\"children\":[1]},{\"children\":[0]}]",
        "[{\"children\":[1,1]},{\"mesh\":0}]", "[{\"children\":[1,2]},{\"children\":[2]},{\"mesh\":0}]",
        "[{\"child\\u0072en\":[1,1]},{\"mesh\":0}]"};
    struct mesh_fixture *fixture = *state;
    for (int i = 0; i < 5; i++) {
        struct mesh_bytes bytes = {.length = 0};
        mesh_gltf(&bytes, mesh_data, nodes[i]);
        mesh_write(mesh_path(fixture, "a.gltf"), bytes.bytes, bytes.length);
        expect_refused(fixture, DPL_REASON_FILE_FORMAT, "tree");
    }
    char *deep = malloc(1000000);
    memset(deep, '[', 1000000);
    memcpy(deep, "{\"a\":", 5);
    mesh_write(mesh_path(fixture, "a.gltf"), deep, 1000000);
    free(deep);
    expect_refused(fixture, DPL_REASON_FILE_FORMAT, "64 brackets");
}

/* 40 000 triangles in a hundred and one places. */
static void too_many_triangles_are_refused(void **state)
{
    struct mesh_fixture *fixture = *state;
    char *bytes = calloc(1, 36 + 120000), text[8192];
    for (int i = 0; i < 40000; i++)
        memcpy(bytes + 36 + 3 * i, "\0\1\2", 3);
    memcpy(bytes, mesh_corners, 36);
    mesh_write(mesh_path(fixture, "a.bin"), bytes, 36 + 120000);
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
    mesh_write_text(fixture, "a.gltf", text);
    expect_refused(fixture, DPL_REASON_LIMIT, "4000000");
}

static void what_is_no_file_is_refused(void **state)
{
    struct mesh_fixture *fixture = *state;
    mesh_path(fixture, "none.obj");
    expect_refused(fixture, DPL_REASON_FILE_READ, "No such file");
    assert_int_equal(mkdir(mesh_path(fixture, "folder.obj"), 0777), 0);
    expect_refused(fixture, DPL_REASON_FILE_READ, "regular file");
    mesh_write_text(fixture, "huge.obj", "v");
    assert_int_equal(truncate(fixture->path, (off_t)257 << 20), 0);
    expect_refused(fixture, DPL_REASON_FILE_READ, "too large");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(files_beside_it_are_read_and_no_others, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(broken_text_is_refused, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(counts_beyond_the_file_are_refused, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(nodes_that_are_no_trees_are_refused, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(too_many_triangles_are_refused, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(too_many_elements_are_refused, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(vertices_placed_too_often_are_refused, mesh_setup, mesh_teardown),
        cmocka_unit_test_setup_teardown(what_is_no_file_is_refused, mesh_setup, mesh_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
