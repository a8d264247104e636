/* Meshes cut short and with changed bytes: a mesh that keeps what io/mesh.h promises, or one error; nothing printed,
 * nothing lost. */
#include "support.h"

#include "mesh.h"

#include <fcntl.h>
#include <sys/stat.h>

#define CHANGES 500 /* a format */

struct fixture {
    struct support_log log;
    char folder[64], path[512];
    int streams[2]; /* stdout and stderr as they were */
};

/* What goes to stdout and stderr is caught in a file. */
static int setup(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    char caught[128];
    support_log_start(&fixture->log);
    support_folder_make(fixture->folder);
    snprintf(caught, sizeof caught, "%s/caught", fixture->folder);
    int to = open(caught, O_WRONLY | O_CREAT, 0600);
    assert_true(to >= 0);
    fflush(NULL);
    for (int i = 0; i < 2; i++) {
        fixture->streams[i] = dup(1 + i);
        dup2(to, 1 + i);
    }
    close(to);
    *state = fixture;
    return 0;
}

/* Checks that nothing was caught. */
static int teardown(void **state)
{
    struct fixture *fixture = *state;
    struct stat status;
    char caught[128];
    fflush(NULL);
    for (int i = 0; i < 2; i++) {
        dup2(fixture->streams[i], 1 + i);
        close(fixture->streams[i]);
    }
    snprintf(caught, sizeof caught, "%s/caught", fixture->folder);
    int failed = stat(caught, &status) != 0 || status.st_size != 0;
    if (failed)
        print_error("something was printed\n");
    support_folder_count(fixture->folder, true);
    free(fixture);
    return failed;
}

static bool is_sound(const struct io_mesh *mesh)
{
    for (int v = 0; v < mesh->vertex_count; v++) {
        double length = 0;
        for (int c = 0; c < 3; c++) {
            length += (double)mesh->normals[v][c] * (double)mesh->normals[v][c];
            if (!(fabsf(mesh->positions[v][c]) <= (float)IO_MESH_COORDINATE_MAX) || !(mesh->colors[v][c] >= 0) ||
                !(mesh->colors[v][c] <= 1))
                return false;
        }
        if (!(fabs(length - 1) < 1e-4))
            return false;
    }
    for (int i = 0; i < mesh->index_count; i++)
        if (mesh->indices[i] >= (unsigned)mesh->vertex_count)
            return false;
    return mesh->index_count > 0 && mesh->index_count % 3 == 0;
}

/* Returns whether it was read. */
static bool read_or_refuse(struct fixture *fixture, const char *name, const char *bytes, size_t length)
{
    struct io_mesh mesh;
    snprintf(fixture->path, sizeof fixture->path, "%s/%s", fixture->folder, name);
    mesh_write(fixture->path, bytes, length);
    bool ok = io_mesh_read(fixture->path, &mesh, &fixture->log.log);
    assert_int_equal(fixture->log.errors, ok ? 0 : 1);
    assert_true(ok ? is_sound(&mesh) : mesh.positions == NULL && strstr(fixture->log.text, fixture->path) != NULL);
    support_log_start(&fixture->log);
    io_mesh_finish(&mesh);
    return ok;
}

/* Text that ends early is a shorter text in OBJ, and may lack a last line feed in PLY; all else is refused. */
static void files_cut_short(void **state)
{
    struct fixture *fixture = *state;
    for (int i = 0; mesh_names[i]; i++) {
        struct mesh_bytes bytes;
        mesh_sample(&bytes, i);
        bool text = !strcmp(mesh_names[i], "text.ply");
        for (size_t cut = 0; cut<bytes.length; cut += bytes.length> 400 ? 3 : 1) {
            bool ok = read_or_refuse(fixture, mesh_names[i], bytes.bytes, cut);
            assert_true(!ok || i == 0 || (text && cut + 2 >= bytes.length));
        }
    }
}

static void changed_bytes(void **state)
{
    struct fixture *fixture = *state;
    uint64_t random = 5;
    for (int i = 0; mesh_names[i]; i++) {
        int read = 0;
        for (int k = 0; k < CHANGES; k++) {
            struct mesh_bytes bytes;
            mesh_sample(&bytes, i);
            for (int changes = 1 + (int)(support_random(&random) % 3); changes > 0; changes--) {
                size_t place = support_random(&random) % bytes.length;
                uint32_t to = support_random(&random);
                if (support_random(&random) % 2)
                    to = (uint32_t) "0123456789-.{}[],\" \n"[to % 20];
                bytes.bytes[place] = (char)to;
            }
            read += read_or_refuse(fixture, mesh_names[i], bytes.bytes, bytes.length);
        }
        assert_true(read > 0 && read < CHANGES);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(files_cut_short, setup, teardown),
        cmocka_unit_test_setup_teardown(changed_bytes, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
