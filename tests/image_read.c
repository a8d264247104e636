/* Pictures from files: what was written comes back, whatever kind of file it was; what is broken is refused with one
 * error that names the file. */
#include "support.h"

#include "io/format.h"

#include <locale.h>
#include <math.h>
#include <openexr.h>
#include <png.h>

static const char *const names[] = {"a.png", "a.exr", "a.pfm"};
static const struct io_format *const formats[] = {&io_png, &io_exr, &io_pfm};

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

static void write_bytes(struct fixture *fixture, const char *name, const void *bytes, size_t length)
{
    FILE *stream = fopen(path_of(fixture, name), "wb");
    assert_non_null(stream);
    assert_int_equal(fwrite(bytes, 1, length, stream), length);
    fclose(stream);
}

static struct dpl_image *read_back(struct fixture *fixture)
{
    struct dpl_image *image = io_read(fixture->path, &fixture->log.log);
    if (!image)
        fail_msg("%s", fixture->log.text);
    return image;
}

static struct dpl_image *random_image(int width, int height)
{
    struct dpl_image *image = dpl_image_create(width, height, NULL);
    uint64_t random = 3;
    for (int i = 0; i < width * height * 3; i++)
        image->pixels[i] = (float)support_random_unit(&random);
    return image;
}

static void what_was_saved_comes_back(void **state)
{
    static const struct {
        const char *name;
        int bits;
        double error;
    } cases[] = {{"a.pfm", 0, 0}, {"a.exr", 0, 0}, {"a.png", 8, 0.5 / 255}, {"a.png", 16, 0.5 / 65535}};
    struct fixture *fixture = *state;
    struct dpl_image *image = random_image(37, 53);
    for (int k = 0; k < 4; k++) {
        const struct dpl_image_format format = {.bits = cases[k].bits};
        assert_true(dpl_image_save(image, path_of(fixture, cases[k].name), &format, NULL));
        struct dpl_image *again = read_back(fixture);
        assert_int_equal(again->width, 37);
        assert_int_equal(again->height, 53);
        for (int i = 0; i < 37 * 53 * 3; i++)
            assert_true(fabs((double)again->pixels[i] - (double)image->pixels[i]) <= cases[k].error * 1.001);
        dpl_image_destroy(again);
    }
    dpl_image_destroy(image);
}

static void expect_grey(struct fixture *fixture, int width, int height, const float *values)
{
    struct dpl_image *image = read_back(fixture);
    assert_int_equal(image->width, width);
    assert_int_equal(image->height, height);
    for (int i = 0; i < width * height * 3; i++)
        assert_true(image->pixels[i] == values[i / 3]);
    dpl_image_destroy(image);
}

/* Big-endian, of one channel: 1, 2 in the lower row, -0.5, 0 in the upper. */
static void pfm_of_the_other_kinds(void **state)
{
    static const char bytes[] = "Pf\n2 2\n1.0\n\x3f\x80\0\0\x40\0\0\0\xbf\0\0\0\0\0\0\0";
    struct fixture *fixture = *state;
    write_bytes(fixture, "a.pfm", bytes, sizeof bytes - 1);
    expect_grey(fixture, 2, 2, (const float[]){-0.5f, 0, 1, 2});
}

/* The third line of the header is a number of any size, with a point whatever the host's locale has for it. */
static void pfm_byte_orders(void **state)
{
    static const char *const orders[] = {"-1.0", "-1", "-.5", "-2.", "-1e-3", "-1.5E+2", " -0.01"};
    static const char *const refused[] = {"", "-", "0", "-0.0", "-.", "inf", "nan", "-1,0", "-1.0.0", "e1"};
    struct fixture *fixture = *state;
    char bytes[64];
    setlocale(LC_NUMERIC, "de_DE.UTF-8"); /* a comma, where the machine knows it */
    for (size_t i = 0; i < sizeof orders / sizeof *orders; i++) {
        int length = snprintf(bytes, sizeof bytes, "Pf\n1 1\n%s\n%c%c\x80\x3f", orders[i], 0, 0);
        write_bytes(fixture, "a.pfm", bytes, (size_t)length);
        expect_grey(fixture, 1, 1, (const float[]){1});
    }
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        snprintf(bytes, sizeof bytes, "Pf\n1 1\n%s\nabcd", refused[i]);
        write_bytes(fixture, "a.pfm", bytes, strlen(bytes));
        assert_null(io_read(fixture->path, &fixture->log.log));
        EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, fixture->path, "no such header");
    }
    setlocale(LC_NUMERIC, "C");
}

/* Grey, 16 bits, an alpha channel that is dropped, and a gamma that is not applied, interlaced. */
static void png_of_the_other_kinds(void **state)
{
    struct fixture *fixture = *state;
    FILE *stream = fopen(path_of(fixture, "a.png"), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_byte rows[2][8] = {{0, 0, 0, 9, 0x12, 0x34, 255, 255}, {255, 255, 0, 0, 0x80, 0, 0, 1}};
    png_init_io(png, stream);
    png_set_IHDR(png, info, 2, 2, 16, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_INTERLACE_ADAM7, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_gAMA(png, info, 0.45455);
    png_set_rows(png, info, (png_bytep[]){rows[0], rows[1]});
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, NULL);
    png_destroy_write_struct(&png, &info);
    fclose(stream);
    expect_grey(fixture, 2, 2, (const float[]){0, 0x1234 / 65535.0f, 1, 0x8000 / 65535.0f});
}

static void ignore_error(exr_const_context_t context, exr_result_t code, const char *text)
{
    (void)context;
    (void)code;
    (void)text;
}

#define EXR_SIDE 40

/* A picture of EXR_SIDE² whose channels all hold `values`, its window not at the origin; `sampling`: pixels to a value,
 * along each axis. */
static void write_exr(struct fixture *fixture, const char *const channels[], int sampling, exr_storage_t storage,
                      exr_compression_t compression, const float *values)
{
    exr_context_t exr;
    exr_context_initializer_t initializer = EXR_DEFAULT_CONTEXT_INITIALIZER;
    initializer.error_handler_fn = ignore_error;
    exr_attr_box2i_t window = {0};
    window.min.x = -6;
    window.min.y = 12;
    window.max.x = window.min.x + EXR_SIDE - 1;
    window.max.y = window.min.y + EXR_SIDE - 1;
    int part = 0, lines = EXR_SIDE;
    bool tiled = storage == EXR_STORAGE_TILED;
    path_of(fixture, "a.exr");
    assert_int_equal(exr_start_write(&exr, fixture->path, EXR_WRITE_FILE_DIRECTLY, &initializer), EXR_ERR_SUCCESS);
    exr_add_part(exr, "only", storage, &part);
    exr_initialize_required_attr_simple(exr, part, EXR_SIDE, EXR_SIDE, compression);
    exr_set_data_window(exr, part, &window);
    if (tiled)
        exr_set_tile_descriptor(exr, part, EXR_SIDE, EXR_SIDE, EXR_TILE_ONE_LEVEL, EXR_TILE_ROUND_DOWN);
    for (int i = 0; channels[i]; i++)
        exr_add_channel(exr, part, channels[i], EXR_PIXEL_HALF, EXR_PERCEPTUALLY_LINEAR, sampling, sampling);
    assert_int_equal(exr_write_header(exr), EXR_ERR_SUCCESS);
    if (!tiled)
        exr_get_scanlines_per_chunk(exr, part, &lines);
    for (int y = 0; y < EXR_SIDE; y += lines) {
        exr_chunk_info_t chunk;
        exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
        assert_int_equal(tiled ? exr_write_tile_chunk_info(exr, part, 0, 0, 0, 0, &chunk)
                               : exr_write_scanline_chunk_info(exr, part, window.min.y + y, &chunk),
                         EXR_ERR_SUCCESS);
        exr_encoding_initialize(exr, part, &chunk, &encoder);
        for (int i = 0; i < encoder.channel_count; i++) {
            encoder.channels[i].encode_from_ptr = (const uint8_t *)(values + y * EXR_SIDE);
            encoder.channels[i].user_pixel_stride = sizeof(float);
            encoder.channels[i].user_line_stride = EXR_SIDE * (int)sizeof(float);
            encoder.channels[i].user_bytes_per_element = sizeof(float);
            encoder.channels[i].user_data_type = EXR_PIXEL_FLOAT;
        }
        exr_encoding_choose_default_routines(exr, part, &encoder);
        assert_int_equal(exr_encoding_run(exr, part, &encoder), EXR_ERR_SUCCESS);
        exr_encoding_destroy(exr, &encoder);
    }
    exr_finish(&exr);
}

/* Halves, lossless compressions; R, G and B among others, Y beside others, a lone channel of any name. */
static void exr_of_the_other_kinds(void **state)
{
    static const char *const channels[][5] = {{"A", "B", "G", "R", NULL}, {"A", "Y", NULL}, {"depth", NULL}};
    static const exr_compression_t compressions[] = {EXR_COMPRESSION_NONE, EXR_COMPRESSION_RLE, EXR_COMPRESSION_ZIPS,
                                                     EXR_COMPRESSION_ZIP, EXR_COMPRESSION_PIZ};
    struct fixture *fixture = *state;
    float values[EXR_SIDE * EXR_SIDE];
    for (int i = 0; i < EXR_SIDE * EXR_SIDE; i++)
        values[i] = (float)(i % 97) / 8 - 1; /* a half holds it exactly */
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 5; i++) {
            write_exr(fixture, channels[k], 1, EXR_STORAGE_SCANLINE, compressions[i], values);
            expect_grey(fixture, EXR_SIDE, EXR_SIDE, values);
        }
    }
    write_exr(fixture, (const char *const[]){"A", "Z", NULL}, 1, EXR_STORAGE_SCANLINE, EXR_COMPRESSION_NONE, values);
    assert_null(io_read(fixture->path, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, fixture->path, "R, G and B");
    write_exr(fixture, (const char *const[]){"B", "G", "R", NULL}, 1, EXR_STORAGE_TILED, EXR_COMPRESSION_NONE, values);
    assert_null(io_read(fixture->path, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, fixture->path, "scan lines");
    for (int k = 0; k < 3; k++) {
        write_exr(fixture, channels[k], 2, EXR_STORAGE_SCANLINE, EXR_COMPRESSION_ZIP, values);
        assert_null(io_read(fixture->path, &fixture->log.log));
        EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, fixture->path, "a value for each pixel");
    }
}

/* The bytes of a small picture in each format; the caller frees them. */
static char *saved_bytes(struct fixture *fixture, const char *name, size_t *length)
{
    struct dpl_image *image = random_image(9, 35);
    assert_true(dpl_image_save(image, path_of(fixture, name), NULL, NULL));
    dpl_image_destroy(image);
    FILE *stream = fopen(fixture->path, "rb");
    char *bytes = malloc(1 << 16);
    *length = fread(bytes, 1, 1 << 16, stream);
    fclose(stream);
    return bytes;
}

/* Reads the first `length` bytes from memory that holds no byte more than a reader may look at. */
static struct dpl_image *read_part(struct fixture *fixture, const struct io_format *format, const char *bytes,
                                   size_t length)
{
    char *copy = malloc(length + 1);
    memcpy(copy, bytes, length);
    copy[length] = '\0';
    struct dpl_image *image = format->read(copy, length, fixture->path, &fixture->log.log);
    free(copy);
    return image;
}

static void files_cut_short_are_refused(void **state)
{
    struct fixture *fixture = *state;
    for (int k = 0; k < 3; k++) {
        size_t length, step = 1;
        char *bytes = saved_bytes(fixture, names[k], &length);
        for (size_t cut = 0; cut < length; cut += step) {
            step = cut < 400 || cut + 40 > length ? 1 : 37;
            assert_null(read_part(fixture, formats[k], bytes, cut));
            EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, fixture->path);
        }
        free(bytes);
    }
}

/* A changed byte gives a picture or one error, and nothing else; half of them are in the header. */
static void changed_bytes_do_no_harm(void **state)
{
    struct fixture *fixture = *state;
    uint64_t random = 5;
    for (int k = 0; k < 3; k++) {
        size_t length;
        char *bytes = saved_bytes(fixture, names[k], &length);
        for (int i = 0; i < 600; i++) {
            size_t range = i % 2 && length > 400 ? 400 : length, place = support_random(&random) % range;
            char before = bytes[place];
            bytes[place] = (char)support_random(&random);
            struct dpl_image *image = read_part(fixture, formats[k], bytes, length);
            assert_int_equal(fixture->log.errors, image ? 0 : 1);
            support_log_start(&fixture->log);
            dpl_image_destroy(image);
            bytes[place] = before;
        }
        free(bytes);
    }
}

static void sizes_that_no_image_has_are_refused(void **state)
{
    static const char *const headers[] = {"PF\n16385 1\n-1\n", "PF\n0 1\n-1\n", "PF\n1 -1\n-1\n",
                                          "PF\n99999999999999999999 9\n-1\n", "Pf\n4294967297 1\n-1\nabcd"};
    struct fixture *fixture = *state;
    for (int i = 0; i < 5; i++) {
        write_bytes(fixture, "a.pfm", headers[i], strlen(headers[i]));
        assert_null(io_read(fixture->path, &fixture->log.log));
        EXPECT_ERROR(&fixture->log, DPL_REASON_LIMIT, fixture->path, "16384");
    }
    write_bytes(fixture, "a.pfm", "PF\n16384 16384\n-1\nabcd", 23);
    assert_null(io_read(fixture->path, &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, fixture->path, "bytes of values");
}

static void what_is_no_file_is_refused(void **state)
{
    struct fixture *fixture = *state;
    assert_null(io_read(path_of(fixture, "none.exr"), &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_READ, fixture->path);
    assert_null(io_read(path_of(fixture, "a.jpg"), &fixture->log.log));
    EXPECT_ERROR(&fixture->log, DPL_REASON_FILE_FORMAT, fixture->path, ".png, .exr, .pfm");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(what_was_saved_comes_back, setup, teardown),
        cmocka_unit_test_setup_teardown(pfm_of_the_other_kinds, setup, teardown),
        cmocka_unit_test_setup_teardown(pfm_byte_orders, setup, teardown),
        cmocka_unit_test_setup_teardown(png_of_the_other_kinds, setup, teardown),
        cmocka_unit_test_setup_teardown(exr_of_the_other_kinds, setup, teardown),
        cmocka_unit_test_setup_teardown(files_cut_short_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(changed_bytes_do_no_harm, setup, teardown),
        cmocka_unit_test_setup_teardown(sizes_that_no_image_has_are_refused, setup, teardown),
        cmocka_unit_test_setup_teardown(what_is_no_file_is_refused, setup, teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
