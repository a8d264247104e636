/* Pictures in files: what is read back by other code is what was written, row by row. */
#include "support.h"

#include "io/format.h"

#include <math.h>
#include <openexr.h>
#include <png.h>

struct fixture {
    struct support_log log;
    char folder[64], path[512];
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
    support_folder_count(fixture->folder, true);
    free(fixture);
    return 0;
}

static const char *path_of(struct fixture *fixture, const char *name)
{
    snprintf(fixture->path, sizeof fixture->path, "%s/%s", fixture->folder, name);
    return fixture->path;
}

/* No two values alike, no side a power of two, numbers below 0 and above 1 among them. */
static struct dpl_image *make_image(int width, int height, float low, float high)
{
    struct dpl_image *image = dpl_image_create(width, height, NULL);
    assert_non_null(image);
    assert_int_equal(image->channels, 3);
    size_t count = (size_t)width * (size_t)height * 3;
    for (size_t i = 0; i < count; i++)
        image->pixels[i] = low + (high - low) * (float)i / (float)(count - 1);
    return image;
}

static void save(struct fixture *fixture, const struct dpl_image *image, const char *name,
                 const struct dpl_image_format *format)
{
    if (!dpl_image_save(image, path_of(fixture, name), format, &fixture->log.log))
        fail_msg("%s", fixture->log.text);
    assert_int_equal(support_folder_count(fixture->folder, false), 1);
}

/* The numbers of a PNG as stored, 8 or 16 bits; the caller frees them. */
static unsigned *read_png(const char *path, int bits, int width, int height)
{
    FILE *stream = fopen(path, "rb");
    assert_non_null(stream);
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, stream);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, NULL);
    assert_int_equal(png_get_image_width(png, info), width);
    assert_int_equal(png_get_image_height(png, info), height);
    assert_int_equal(png_get_bit_depth(png, info), bits);
    assert_int_equal(png_get_color_type(png, info), PNG_COLOR_TYPE_RGB);
    assert_int_equal(png_get_valid(png, info, PNG_INFO_gAMA), 0);
    png_bytepp rows = png_get_rows(png, info);
    unsigned *numbers = malloc((size_t)(width * height * 3) * sizeof *numbers);
    for (int y = 0; y < height; y++)
        for (int i = 0; i < width * 3; i++)
            numbers[y * width * 3 + i] =
                bits == 8 ? rows[y][i] : (unsigned)rows[y][2 * i] << 8 | (unsigned)rows[y][2 * i + 1];
    png_destroy_read_struct(&png, &info, NULL);
    fclose(stream);
    return numbers;
}

/* Every number is checked against the value that it stands for. */
static void check_png(struct fixture *fixture, int bits, float black, float white, float low, float high)
{
    const int width = 37, height = 23, largest = bits == 8 ? 255 : 65535;
    struct dpl_image *image = make_image(width, height, low, high);
    save(fixture, image, "a.png", &(struct dpl_image_format){bits == 8 ? 0 : bits, black, white});
    unsigned *numbers = read_png(fixture->path, bits, width, height);
    if (black == white)
        white = 1;
    for (int i = 0; i < width * height * 3; i++) {
        double value = ((double)image->pixels[i] - black) / ((double)white - black);
        double wanted = fmin(fmax(value, 0), 1) * largest;
        /* half a step of rounding, and what single precision adds to it */
        assert_true(fabs(numbers[i] - wanted) <= 0.5 + 0.01);
    }
    free(numbers);
    dpl_image_destroy(image);
}

static void png_holds_rounded_values(void **state)
{
    check_png(*state, 8, 0, 0, 0, 1);
    check_png(*state, 16, 0, 0, 0, 1);
}

static void png_clamps_to_black_and_white(void **state)
{
    check_png(*state, 8, 0, 0, -1, 3);
    check_png(*state, 16, 0, 0, -1, 3);
    check_png(*state, 16, -2, 2, -3, 3);
    check_png(*state, 8, 0.5f, 4, -3, 6);
    check_png(*state, 8, 1, 0, -0.2f, 1.2f); /* negative */
}

static void png_is_read_as_it_was_written(void **state)
{
    struct fixture *fixture = *state;
    struct dpl_image *image = make_image(16, 16, 0, 767.0f / 255);
    for (int i = 0; i < 768; i++)
        image->pixels[i] = (float)(i % 256) / 255;
    save(fixture, image, "a.png", NULL);
    struct dpl_image *again = io_read(fixture->path, &fixture->log.log);
    assert_non_null(again);
    assert_memory_equal(again->pixels, image->pixels, 768 * sizeof(float));
    dpl_image_destroy(again);
    dpl_image_destroy(image);
}

/* "PF", width, height, a negative number for little endian, then rows from the bottom one upwards. */
static void pfm_holds_the_bottom_row_first(void **state)
{
    struct fixture *fixture = *state;
    const int width = 37, height = 23;
    struct dpl_image *image = make_image(width, height, -5, 1e6f);
    save(fixture, image, "a.pfm", NULL);
    FILE *stream = fopen(fixture->path, "rb");
    int columns, rows;
    double order;
    assert_int_equal(fscanf(stream, "PF %d %d %lf%*[\n]", &columns, &rows, &order), 3);
    assert_int_equal(columns, width);
    assert_int_equal(rows, height);
    assert_true(order == -1);
    for (int y = height - 1; y >= 0; y--) {
        float row[37 * 3];
        assert_int_equal(fread(row, sizeof row, 1, stream), 1);
        assert_memory_equal(row, image->pixels + (size_t)(y * width * 3), sizeof row);
    }
    assert_int_equal(fgetc(stream), EOF);
    fclose(stream);
    dpl_image_destroy(image);
}

/* Decodes every chunk of scan lines into planes of floats: red, green, blue. */
static void read_exr_chunks(exr_context_t exr, int width, int height, float *planes)
{
    int32_t lines;
    assert_int_equal(exr_get_scanlines_per_chunk(exr, 0, &lines), EXR_ERR_SUCCESS);
    for (int y = 0; y < height; y += lines) {
        exr_chunk_info_t chunk;
        exr_decode_pipeline_t decoder = EXR_DECODE_PIPELINE_INITIALIZER;
        assert_int_equal(exr_read_scanline_chunk_info(exr, 0, y, &chunk), EXR_ERR_SUCCESS);
        assert_int_equal(exr_decoding_initialize(exr, 0, &chunk, &decoder), EXR_ERR_SUCCESS);
        assert_int_equal(decoder.channel_count, 3);
        for (int i = 0; i < 3; i++) {
            exr_coding_channel_info_t *channel = decoder.channels + i;
            int plane = (int)(strchr("RGB", *channel->channel_name) - "RGB");
            assert_int_equal(channel->data_type, EXR_PIXEL_FLOAT);
            channel->decode_to_ptr = (uint8_t *)(planes + (plane * height + y) * width);
            channel->user_pixel_stride = channel->user_bytes_per_element = sizeof(float);
            channel->user_line_stride = width * (int)sizeof(float);
            channel->user_data_type = EXR_PIXEL_FLOAT;
        }
        assert_int_equal(exr_decoding_choose_default_routines(exr, 0, &decoder), EXR_ERR_SUCCESS);
        assert_int_equal(exr_decoding_run(exr, 0, &decoder), EXR_ERR_SUCCESS);
        exr_decoding_destroy(exr, &decoder);
    }
}

static void exr_holds_the_same_floats(void **state)
{
    struct fixture *fixture = *state;
    const int width = 37, height = 53; /* more than one chunk of 16 lines, and a short one */
    struct dpl_image *image = make_image(width, height, -5, 1e6f);
    save(fixture, image, "a.exr", NULL);
    exr_context_t exr;
    exr_context_initializer_t initializer = EXR_DEFAULT_CONTEXT_INITIALIZER;
    assert_int_equal(exr_start_read(&exr, fixture->path, &initializer), EXR_ERR_SUCCESS);
    exr_attr_box2i_t window;
    assert_int_equal(exr_get_data_window(exr, 0, &window), EXR_ERR_SUCCESS);
    assert_int_equal(window.max.x - window.min.x + 1, width);
    assert_int_equal(window.max.y - window.min.y + 1, height);
    float *planes = calloc((size_t)(width * height), 3 * sizeof *planes);
    read_exr_chunks(exr, width, height, planes);
    for (int i = 0; i < width * height; i++)
        for (int c = 0; c < 3; c++)
            assert_true(planes[c * width * height + i] == image->pixels[i * 3 + c]);
    free(planes);
    assert_int_equal(exr_finish(&exr), EXR_ERR_SUCCESS);
    dpl_image_destroy(image);
}

/* What is no number becomes black in PNG; the formats of floats keep it. None may crash. */
static void values_that_are_no_numbers_are_written(void **state)
{
    static const char *const names[] = {"a.pfm", "a.exr", "a.png"};
    struct fixture *fixture = *state;
    struct dpl_image *image = make_image(5, 1, 0, 1);
    const float special[] = {NAN, INFINITY, -INFINITY, 3e38f, -3e38f, 1e-40f, -0.0f};
    memcpy(image->pixels, special, sizeof special);
    for (int i = 0; i < 3; i++) {
        save(fixture, image, names[i], NULL);
        if (i < 2)
            unlink(fixture->path);
    }
    static const unsigned wanted[] = {0, 255, 0, 255, 0, 0, 0};
    unsigned *numbers = read_png(fixture->path, 8, 5, 1);
    for (int i = 0; i < 7; i++)
        assert_int_equal(numbers[i], wanted[i]);
    free(numbers);
    dpl_image_destroy(image);
}

static void endings_choose_the_format(void **state)
{
    static const char *const known[] = {"a.png", "A.PNG", "a.b.exr", "a.Pfm", "/x/y.z/a.pfm", NULL};
    static const char *const unknown[] = {"a.jpg", "a", "", ".", "a.png.", "a.pngx", "x.png/a", NULL};
    struct fixture *fixture = *state;
    struct dpl_image *image = make_image(2, 2, 0, 1);
    for (int i = 0; known[i]; i++)
        assert_true(dpl_image_format_known(known[i], &fixture->log.log));
    assert_int_equal(fixture->log.errors, 0);
    for (int i = 0; unknown[i]; i++) {
        assert_false(dpl_image_format_known(unknown[i], &fixture->log.log));
        EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, unknown[i], ".png, .exr, .pfm");
        assert_false(dpl_image_save(image, path_of(fixture, unknown[i]), NULL, &fixture->log.log));
        EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, unknown[i], ".png, .exr, .pfm");
    }
    assert_int_equal(support_folder_count(fixture->folder, false), 0);
    dpl_image_destroy(image);
}

static void sizes_out_of_range_are_refused(void **state)
{
    static const int sizes[][2] = {{0, 1}, {1, 0}, {-1, 1}, {1, -1}, {DPL_IMAGE_SIDE_MAX + 1, 1}, {1, 1 << 30}};
    struct fixture *fixture = *state;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        assert_null(dpl_image_create(sizes[i][0], sizes[i][1], &fixture->log.log));
        EXPECT_ERROR(&fixture->log, DPL_REASON_LIMIT, "16384");
    }
    dpl_image_destroy(dpl_image_create(DPL_IMAGE_SIDE_MAX, 1, &fixture->log.log));
    dpl_image_destroy(NULL);
    assert_int_equal(fixture->log.errors, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(png_holds_rounded_values, setup, teardown),
        cmocka_unit_test_setup_teardown(png_clamps_to_black_and_white, setup, teardown),
        cmocka_unit_test_setup_teardown(png_is_read_as_it_was_written, setup, teardown),
        cmocka_unit_test_setup_teardown(pfm_holds_the_bottom_row_first, setup, teardown),
        cmocka_unit_test_setup_teardown(exr_holds_the_same_floats, setup, teardown),
        cmocka_unit_test_setup_teardown(values_that_are_no_numbers_are_written, setup, teardown),
        cmocka_unit_test_setup_teardown(endings_choose_the_format, setup, teardown),
        cmocka_unit_test_setup_teardown(sizes_out_of_range_are_refused, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
