/* OpenEXR through OpenEXRCore. Written: one part, scan lines, RGB as 32-bit floats, ZIP compression. Read: the scan
 * lines of the first part, whatever their type and compression. */
#include "base/log.h"
#include "io/format.h"

#include <errno.h>
#include <openexr.h>
#include <string.h>

struct exr_output {
    FILE *stream;
    int error; /* errno of the write that failed */
};

static int64_t write_bytes(exr_const_context_t context, void *user, const void *bytes, uint64_t size, uint64_t offset,
                           exr_stream_error_func_ptr_t error)
{
    (void)context;
    (void)error;
    struct exr_output *output = user;
    if (fseek(output->stream, (long)offset, SEEK_SET) == 0 && fwrite(bytes, 1, size, output->stream) == size)
        return (int64_t)size;
    output->error = errno;
    return -1;
}

/* Called with the context locked, so that nothing can be asked of it: the result alone tells. */
static void ignore_error(exr_const_context_t context, exr_result_t code, const char *text)
{
    (void)context;
    (void)code;
    (void)text;
}

static bool write_header(exr_context_t exr, const struct dpl_image *image)
{
    int part = 0;
    bool ok = exr_add_part(exr, NULL, EXR_STORAGE_SCANLINE, &part) == EXR_ERR_SUCCESS &&
              exr_initialize_required_attr_simple(exr, part, image->width, image->height, EXR_COMPRESSION_ZIP) ==
                  EXR_ERR_SUCCESS;
    static const char *const names[] = {"B", "G", "R"};
    for (int i = 0; ok && i < 3; i++)
        ok = exr_add_channel(exr, part, names[i], EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1) ==
             EXR_ERR_SUCCESS;
    return ok && exr_write_header(exr) == EXR_ERR_SUCCESS;
}

/* Points each of the chunk's channels at its place in the interleaved image. */
static void attach_channels(exr_encode_pipeline_t *encoder, const struct dpl_image *image, int y)
{
    for (int i = 0; i < encoder->channel_count; i++) {
        exr_coding_channel_info_t *channel = encoder->channels + i;
        int index = channel->channel_name[0] == 'R' ? 0 : channel->channel_name[0] == 'G' ? 1 : 2;
        float *first = image->pixels + (size_t)y * (size_t)image->width * (size_t)image->channels + index;
        channel->encode_from_ptr = (const uint8_t *)first;
        channel->user_pixel_stride = image->channels * (int)sizeof(float);
        channel->user_line_stride = image->width * image->channels * (int)sizeof(float);
        channel->user_bytes_per_element = sizeof(float);
        channel->user_data_type = EXR_PIXEL_FLOAT;
    }
}

static bool write_chunks(exr_context_t exr, const struct dpl_image *image)
{
    int32_t lines = 0;
    if (exr_get_scanlines_per_chunk(exr, 0, &lines) != EXR_ERR_SUCCESS)
        return false;
    bool ok = true;
    for (int y = 0; ok && y < image->height; y += lines) {
        exr_chunk_info_t chunk;
        exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
        ok = exr_write_scanline_chunk_info(exr, 0, y, &chunk) == EXR_ERR_SUCCESS &&
             exr_encoding_initialize(exr, 0, &chunk, &encoder) == EXR_ERR_SUCCESS;
        if (!ok)
            break;
        attach_channels(&encoder, image, y);
        ok = exr_encoding_choose_default_routines(exr, 0, &encoder) == EXR_ERR_SUCCESS &&
             exr_encoding_run(exr, 0, &encoder) == EXR_ERR_SUCCESS;
        exr_encoding_destroy(exr, &encoder);
    }
    return ok;
}

static bool write_exr(FILE *stream, const struct dpl_image *image, const struct dpl_image_format *format,
                      const char *path, const struct dpl_log *log)
{
    (void)format;
    struct exr_output output = {.stream = stream};
    exr_context_initializer_t initializer = EXR_DEFAULT_CONTEXT_INITIALIZER;
    initializer.user_data = &output;
    initializer.write_fn = write_bytes;
    initializer.error_handler_fn = ignore_error;
    exr_context_t exr;
    bool ok = exr_start_write(&exr, path, EXR_WRITE_FILE_DIRECTLY, &initializer) == EXR_ERR_SUCCESS;
    if (ok) {
        ok = write_header(exr, image) && write_chunks(exr, image);
        ok = exr_finish(&exr) == EXR_ERR_SUCCESS && ok;
    }
    return ok || base_fail(log, DPL_REASON_FILE_WRITE, "%s: cannot be written: %s", path,
                           output.error ? strerror(output.error) : "OpenEXR refuses it");
}

/* A file in memory that is being read. */
struct exr_input {
    const char *bytes;
    size_t length;
};

static int64_t read_bytes(exr_const_context_t context, void *user, void *bytes, uint64_t size, uint64_t offset,
                          exr_stream_error_func_ptr_t error)
{
    (void)context;
    (void)error;
    const struct exr_input *input = user;
    size_t left = offset < input->length ? input->length - (size_t)offset : 0,
           count = size < left ? (size_t)size : left;
    memcpy(bytes, input->bytes + (count ? offset : 0), count);
    return (int64_t)count;
}

static int64_t input_size(exr_const_context_t context, void *user)
{
    (void)context;
    const struct exr_input *input = user;
    return (int64_t)input->length;
}

/* It has a value for every pixel. */
static bool is_whole(const exr_attr_chlist_entry_t *channel)
{
    return channel->x_sampling == 1 && channel->y_sampling == 1;
}

/* The file's channels that become red, green and blue: R, G and B, or else Y, or else the only one there is. */
static bool find_channels(exr_context_t exr, const char *names[3])
{
    const exr_attr_chlist_t *list;
    static const char *const wanted[] = {"R", "G", "B", "Y"};
    const char *found[4] = {NULL};
    if (exr_get_channels(exr, 0, &list) != EXR_ERR_SUCCESS)
        return false;
    for (int i = 0; i < list->num_channels; i++)
        for (int k = 0; k < 4; k++)
            if (!strcmp(list->entries[i].name.str, wanted[k]) && is_whole(list->entries + i))
                found[k] = list->entries[i].name.str;
    bool colored = found[0] && found[1] && found[2];
    if (!found[3] && list->num_channels == 1 && is_whole(list->entries))
        found[3] = list->entries[0].name.str;
    for (int k = 0; k < 3; k++)
        names[k] = colored ? found[k] : found[3];
    return names[0] != NULL;
}

/* Points the chunk's channels at the image's first channel that takes them; others are skipped. */
static void attach_decoder(exr_decode_pipeline_t *decoder, const struct dpl_image *image, int y, const char *names[3])
{
    for (int i = 0; i < decoder->channel_count; i++) {
        exr_coding_channel_info_t *channel = decoder->channels + i;
        int index = 0;
        while (index < 3 && strcmp(channel->channel_name, names[index]) != 0)
            index++;
        float *first = image->pixels + (size_t)y * (size_t)image->width * 3 + index;
        channel->decode_to_ptr = index < 3 ? (uint8_t *)first : NULL;
        channel->user_pixel_stride = 3 * (int)sizeof(float);
        channel->user_line_stride = image->width * 3 * (int)sizeof(float);
        channel->user_bytes_per_element = sizeof(float);
        channel->user_data_type = EXR_PIXEL_FLOAT;
    }
}

static bool read_chunks(exr_context_t exr, const exr_attr_box2i_t *window, const char *names[3],
                        const struct dpl_image *image)
{
    int32_t lines = 0;
    bool ok = exr_get_scanlines_per_chunk(exr, 0, &lines) == EXR_ERR_SUCCESS && lines > 0;
    for (int y = 0; ok && y < image->height; y += lines) {
        exr_chunk_info_t chunk;
        exr_decode_pipeline_t decoder = EXR_DECODE_PIPELINE_INITIALIZER;
        int height = image->height - y < lines ? image->height - y : lines;
        ok = exr_read_scanline_chunk_info(exr, 0, window->min.y + y, &chunk) == EXR_ERR_SUCCESS &&
             chunk.start_y == window->min.y + y && chunk.height == height && chunk.width == image->width &&
             exr_decoding_initialize(exr, 0, &chunk, &decoder) == EXR_ERR_SUCCESS;
        if (!ok)
            break;
        attach_decoder(&decoder, image, y, names);
        ok = exr_decoding_choose_default_routines(exr, 0, &decoder) == EXR_ERR_SUCCESS &&
             exr_decoding_run(exr, 0, &decoder) == EXR_ERR_SUCCESS;
        exr_decoding_destroy(exr, &decoder);
    }
    return ok;
}

static struct dpl_image *read_image(exr_context_t exr, const char *path, const struct dpl_log *log)
{
    exr_attr_box2i_t window;
    exr_storage_t storage;
    const char *names[3];
    if (exr_get_storage(exr, 0, &storage) != EXR_ERR_SUCCESS || storage != EXR_STORAGE_SCANLINE ||
        exr_get_data_window(exr, 0, &window) != EXR_ERR_SUCCESS || !find_channels(exr, names)) {
        base_fail(log, DPL_REASON_FILE_FORMAT,
                  "%s: an EXR of another kind (accepted: scan lines of R, G and B, of Y, or of one channel, a value "
                  "for each pixel)",
                  path);
        return NULL;
    }
    long long width = (long long)window.max.x - window.min.x + 1, height = (long long)window.max.y - window.min.y + 1;
    if (!io_size_fits(width, height, path, log))
        return NULL;
    struct dpl_image *image = dpl_image_create((int)width, (int)height, log);
    if (!image || read_chunks(exr, &window, names, image)) {
        for (size_t i = 0; image && names[1] == names[0] && i < (size_t)(width * height); i++)
            image->pixels[3 * i + 1] = image->pixels[3 * i + 2] = image->pixels[3 * i];
        return image;
    }
    base_fail(log, DPL_REASON_FILE_FORMAT, "%s: cannot be read as EXR: broken or cut short", path);
    dpl_image_destroy(image);
    return NULL;
}

static struct dpl_image *read_exr(const char *bytes, size_t length, const char *path, const struct dpl_log *log)
{
    struct exr_input input = {bytes, length};
    exr_context_initializer_t initializer = EXR_DEFAULT_CONTEXT_INITIALIZER;
    initializer.user_data = &input;
    initializer.read_fn = read_bytes;
    initializer.size_fn = input_size;
    initializer.error_handler_fn = ignore_error;
    initializer.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
    exr_context_t exr;
    if (exr_start_read(&exr, path, &initializer) != EXR_ERR_SUCCESS) {
        base_fail(log, DPL_REASON_FILE_FORMAT, "%s: cannot be read as EXR: no such header", path);
        return NULL;
    }
    struct dpl_image *image = read_image(exr, path, log);
    exr_finish(&exr);
    return image;
}

const struct io_format io_exr = {".exr", write_exr, read_exr};
