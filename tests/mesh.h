/* tests/mesh.h: small files of meshes, each a tetrahedron of volume 1/6 with its corners on the axes, and a fixture
 * that reads them. Include support.h before. */
#ifndef TESTS_MESH_H
#define TESTS_MESH_H

#include "io/mesh.h"

struct mesh_bytes {
    char bytes[4096];
    size_t length;
};

static const float mesh_corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
static const unsigned char mesh_faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

static const char *const mesh_names[] = {"a.obj", "text.ply", "binary.ply", "a.stl", "a.glb", "a.gltf", NULL};

static inline void mesh_add(struct mesh_bytes *to, const void *bytes, size_t length)
{
    assert_true(to->length + length <= sizeof to->bytes);
    memcpy(to->bytes + to->length, bytes, length);
    to->length += length;
}

static inline void mesh_print(struct mesh_bytes *to, const char *format, ...)
{
    char text[2048];
    va_list arguments;
    va_start(arguments, format);
    mesh_add(to, text, (size_t)vsnprintf(text, sizeof text, format, arguments));
    va_end(arguments);
}

static inline void mesh_add_number(struct mesh_bytes *to, uint32_t number)
{
    const unsigned char bytes[4] = {number & 255, number >> 8 & 255, number >> 16 & 255, (unsigned char)(number >> 24)};
    mesh_add(to, bytes, 4);
}

static inline void mesh_obj(struct mesh_bytes *to)
{
    for (int i = 0; i < 4; i++)
        mesh_print(to, "v %g %g %g\n", (double)mesh_corners[i][0], (double)mesh_corners[i][1],
                   (double)mesh_corners[i][2]);
    for (int i = 0; i < 4; i++)
        mesh_print(to, "f %d %d %d\n", mesh_faces[i][0] + 1, mesh_faces[i][1] + 1, mesh_faces[i][2] + 1);
}

static inline void mesh_ply(struct mesh_bytes *to, bool text)
{
    mesh_print(to,
               "ply\nformat %s 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
               "property uchar red\nproperty uchar green\nproperty uchar blue\n"
               "element face 4\nproperty list uchar int vertex_indices\nend_header\n",
               text ? "ascii" : "binary_little_endian");
    for (int i = 0; i < 4; i++) {
        if (text)
            mesh_print(to, "%g %g %g 255 51 0\n", (double)mesh_corners[i][0], (double)mesh_corners[i][1],
                       (double)mesh_corners[i][2]);
        else {
            mesh_add(to, mesh_corners[i], 12);
            mesh_add(to, "\xff\x33", 3);
        }
    }
    for (int i = 0; i < 4; i++) {
        if (text)
            mesh_print(to, "3 %d %d %d\n", mesh_faces[i][0], mesh_faces[i][1], mesh_faces[i][2]);
        else {
            mesh_add(to, "\3", 1);
            for (int k = 0; k < 3; k++)
                mesh_add_number(to, mesh_faces[i][k]);
        }
    }
}

static inline void mesh_stl(struct mesh_bytes *to)
{
    static const char zeros[80];
    mesh_add(to, zeros, 80);
    mesh_add_number(to, 4);
    for (int i = 0; i < 4; i++) {
        mesh_add(to, zeros, 12); /* the normal: to be made */
        for (int k = 0; k < 3; k++)
            mesh_add(to, mesh_corners[mesh_faces[i][k]], 12);
        mesh_add(to, zeros, 2);
    }
}

/* Text of glTF whose buffer of 60 bytes has corners and faces: `uri` is a part of its buffer, `nodes` the list. */
static inline void mesh_gltf(struct mesh_bytes *to, const char *uri, const char *nodes)
{
    mesh_print(to,
               "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":%s,"
               "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1,\"material\":0}]}],"
               "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0.25,0.125,1]}}],"
               "\"buffers\":[{%s\"byteLength\":60}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":48},"
               "{\"buffer\":0,\"byteOffset\":48,\"byteLength\":12}],\"accessors\":["
               "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"
               "{\"bufferView\":1,\"componentType\":5121,\"count\":12,\"type\":\"SCALAR\"}]}",
               nodes, uri);
}

static inline void mesh_glb(struct mesh_bytes *to, const char *nodes)
{
    struct mesh_bytes text = {.length = 0};
    mesh_gltf(&text, "", nodes);
    while (text.length % 4 != 0)
        mesh_print(&text, " ");
    mesh_print(to, "glTF");
    mesh_add_number(to, 2);
    mesh_add_number(to, (uint32_t)(12 + 8 + text.length + 8 + 60));
    mesh_add_number(to, (uint32_t)text.length);
    mesh_print(to, "JSON");
    mesh_add(to, text.bytes, text.length);
    mesh_add_number(to, 60);
    mesh_add(to, "BIN", 4);
    mesh_add(to, mesh_corners, 48);
    mesh_add(to, mesh_faces, 12);
}

static const char mesh_data[] = "\"uri\":\"data:application/octet-stream;base64,"
                                "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
                                "AAIBAAEDAAMCAQID\",";

/* The file of that entry of mesh_names. */
static inline void mesh_sample(struct mesh_bytes *to, int entry)
{
    to->length = 0;
    switch (entry) {
    case 0:
        mesh_obj(to);
        break;
    case 1:
    case 2:
        mesh_ply(to, entry == 1);
        break;
    case 3:
        mesh_stl(to);
        break;
    case 4:
        mesh_glb(to, "[{\"mesh\":0}]");
        break;
    default:
        mesh_gltf(to, mesh_data, "[{\"mesh\":0}]");
    }
}

static inline void mesh_write(const char *path, const void *bytes, size_t length)
{
    FILE *stream = fopen(path, "wb");
    assert_non_null(stream);
    assert_int_equal(fwrite(bytes, 1, length, stream), length);
    fclose(stream);
}

/* A folder for files, and what was read from the last. */
struct mesh_fixture {
    struct support_log log;
    char folder[64], path[512];
    struct io_mesh mesh;
};

static inline int mesh_setup(void **state)
{
    struct mesh_fixture *fixture = calloc(1, sizeof *fixture);
    support_log_start(&fixture->log);
    support_folder_make(fixture->folder);
    *state = fixture;
    return 0;
}

static inline int mesh_teardown(void **state)
{
    struct mesh_fixture *fixture = *state;
    io_mesh_finish(&fixture->mesh);
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

static inline const char *mesh_path(struct mesh_fixture *fixture, const char *name)
{
    snprintf(fixture->path, sizeof fixture->path, "%s/%s", fixture->folder, name);
    return fixture->path;
}

static inline void mesh_write_text(struct mesh_fixture *fixture, const char *name, const char *text)
{
    mesh_write(mesh_path(fixture, name), text, strlen(text));
}

static inline const struct io_mesh *mesh_read(struct mesh_fixture *fixture)
{
    io_mesh_finish(&fixture->mesh);
    if (!io_mesh_read(fixture->path, &fixture->mesh, &fixture->log.log))
        fail_msg("%s", fixture->log.text);
    return &fixture->mesh;
}

#endif
