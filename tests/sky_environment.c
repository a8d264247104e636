/* A sky from a picture: where its parts come to stand, what is kept of their light, and what is no picture of a sky. */
#include "sky.h"

#include "base/log.h"

struct folder {
    char name[64], path[128];
};

/* Radiance 1 + x / 2, 1 + z / 2 and height of the direction; below the horizon what must not be seen. */
static void write_sky(struct folder *folder, const char *name, int width, int height)
{
    struct dpl_image *image = dpl_image_create(width, height, NULL);
    for (int j = 0; j < height; j++)
        for (int i = 0; i < width; i++) {
            double d[3];
            direction_of(90 - 180 * (j + 0.5) / height, 360 * (i + 0.5) / width, d);
            float *pixel = image->pixels + (j * width + i) * 3;
            pixel[0] = j < height / 2 ? (float)(1 + d[0] / 2) : 1000;
            pixel[1] = j < height / 2 ? (float)(1 + d[2] / 2) : 1000;
            pixel[2] = j < height / 2 ? (float)d[1] : -1;
        }
    snprintf(folder->path, sizeof folder->path, "%s/%s", folder->name, name);
    assert_true(dpl_image_save(image, folder->path, NULL, NULL));
    dpl_image_destroy(image);
}

static void check_sky(const struct optics_sky *sky, double turn, double tolerance)
{
    for (double elevation = 2; elevation < 90; elevation += 8)
        for (double azimuth = 0; azimuth < 360; azimuth += 17) {
            double direction[3], source[3], radiance[3];
            direction_of(elevation, azimuth, direction);
            direction_of(elevation, azimuth - turn, source);
            optics_sky_radiance(sky, direction, radiance);
            assert_true(fabs(radiance[0] - (1 + source[0] / 2)) < tolerance);
            assert_true(fabs(radiance[1] - (1 + source[2] / 2)) < tolerance);
            assert_true(fabs(radiance[2] - source[1]) < tolerance);
        }
}

static void pictures_stand_where_they_should(void **state)
{
    struct fixture *fixture = *state;
    static const int widths[] = {1024, 256, 300, 64};
    struct folder folder;
    support_folder_make(folder.name);
    fixture->settings.model = SKY_ENVIRONMENT;
    for (int i = 0; i < 4; i++) {
        char name[32];
        snprintf(name, sizeof name, "%d.%s", i, i & 1 ? "pfm" : "exr");
        write_sky(&folder, name, widths[i], widths[i] / 2);
        snprintf(fixture->settings.environment, sizeof fixture->settings.environment, "%s", folder.path);
        for (double turn = -90; turn < 200; turn += 111.3) {
            fixture->settings.turn = turn;
            make(fixture);
            check_sky(&fixture->sky, turn, widths[i] < 256 ? 0.02 : 0.01);
        }
    }
    expect_share(fixture->sky.irradiance[0], M_PI, 0.01);
    expect_share(fixture->sky.irradiance[2], 2 * M_PI / 3, 0.01);
    fixture->settings.brightness = 3;
    make(fixture);
    expect_share(fixture->sky.irradiance[0], 3 * M_PI, 0.01);
    support_folder_count(folder.name, true);
}

/* All light is kept when a picture is made smaller: one bright pixel, wherever it lies. */
static void small_lights_are_kept(void **state)
{
    struct fixture *fixture = *state;
    struct folder folder;
    support_folder_make(folder.name);
    fixture->settings.model = SKY_ENVIRONMENT;
    fixture->settings.sun = 0;
    memset(fixture->settings.ground, 0, sizeof fixture->settings.ground);
    for (int i = 0; i < 5; i++) {
        const int width = 1500, height = 750, x = (i * 337 + 1499) % 1500, y = 100 + i * 61;
        struct dpl_image *image = dpl_image_create(width, height, NULL);
        image->pixels[(y * width + x) * 3] = 1e6f;
        snprintf(folder.path, sizeof folder.path, "%s/%d.pfm", folder.name, i);
        assert_true(dpl_image_save(image, folder.path, NULL, NULL));
        dpl_image_destroy(image);
        snprintf(fixture->settings.environment, sizeof fixture->settings.environment, "%s", folder.path);
        make(fixture);
        double zenith = M_PI * (y + 0.5) / height;
        double wanted = 1e6 * sin(zenith) * 2 * M_PI * M_PI / (width * height); /* integral over the sphere */
        double found = 0;
        for (int j = 0; j < SKY_ROWS; j++) {
            double angle = (cos(M_PI * j / SKY_ROWS) - cos(M_PI * (j + 1) / SKY_ROWS)) * 2 * M_PI / SKY_COLUMNS;
            for (int k = 0; k < SKY_COLUMNS; k++)
                found += angle * (double)fixture->sky.texels[(j * SKY_COLUMNS + k) * 3];
        }
        expect_share(found, wanted, 1e-3);
    }
    support_folder_count(folder.name, true);
}

static void refuse(struct fixture *fixture, const char *path, enum dpl_reason reason, const char *part)
{
    const uint64_t before = fixture->sky.fingerprint;
    const float texel = fixture->sky.texels[0];
    snprintf(fixture->settings.environment, sizeof fixture->settings.environment, "%s", path);
    assert_false(optics_sky_make(&fixture->sky, &fixture->settings, &fixture->sun, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, reason, path, part);
    assert_true(fixture->sky.fingerprint == before && fixture->sky.texels[0] == texel);
}

/* What is no picture of a sky is said, and the sky stays. */
static void what_cannot_be_read_is_said(void **state)
{
    struct fixture *fixture = *state;
    struct folder folder;
    support_folder_make(folder.name);
    make(fixture);
    fixture->settings.model = SKY_ENVIRONMENT;
    refuse(fixture, "", DPL_REASON_VALUE, "sky.environment");
    refuse(fixture, "/nowhere/sky.exr", DPL_REASON_FILE_READ, "sky.exr");
    refuse(fixture, "sky.jpeg", DPL_REASON_FILE_FORMAT, ".exr");
    struct dpl_image *image = dpl_image_create(8, 4, NULL);
    image->pixels[40] = INFINITY;
    snprintf(folder.path, sizeof folder.path, "%s/sky.pfm", folder.name);
    assert_true(dpl_image_save(image, folder.path, NULL, NULL));
    refuse(fixture, folder.path, DPL_REASON_FILE_FORMAT, "row 1");
    image->pixels[40] = NAN;
    snprintf(folder.path, sizeof folder.path, "%s/other.pfm", folder.name);
    assert_true(dpl_image_save(image, folder.path, NULL, NULL));
    refuse(fixture, folder.path, DPL_REASON_FILE_FORMAT, "row 1");
    dpl_image_destroy(image);
    support_folder_count(folder.name, true);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(pictures_stand_where_they_should, setup, teardown),
        cmocka_unit_test_setup_teardown(small_lights_are_kept, setup, teardown),
        cmocka_unit_test_setup_teardown(what_cannot_be_read_is_said, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
