/* OpenEXR through OpenEXRCore: one part, scan lines, RGB as 32-bit floats, ZIP compression. */
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

const struct io_format io_exr = {".exr", write_exr};
