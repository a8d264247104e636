#include "dapple/measure.h"

#include "base/log.h"
#include "measure/pair.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* Bits of a number that is not negative: they are in the order of the numbers (IEEE 754). */
static uint32_t difference_bits(const struct dpl_image *image, const struct dpl_image *reference, double gain, size_t i)
{
    float difference = (float)fabs(image->pixels[i] * gain - reference->pixels[i]);
    uint32_t bits;
    memcpy(&bits, &difference, sizeof bits);
    return bits;
}

/* The least difference that a share of all differences does not exceed: found byte by byte, from the first, by
 * counting what starts with the bytes found so far. */
static double percentile(const struct dpl_image *image, const struct dpl_image *reference, double gain, double share)
{
    size_t count = pair_count(image), rank = (size_t)ceil(share * (double)count);
    uint32_t found = 0;
    for (int shift = 24; shift >= 0; shift -= 8) {
        size_t counts[256] = {0};
        for (size_t i = 0; i < count; i++) {
            uint32_t bits = difference_bits(image, reference, gain, i);
            if ((uint64_t)bits >> (shift + 8) == (uint64_t)found >> (shift + 8))
                counts[bits >> shift & 255]++;
        }
        uint32_t byte = 0;
        for (; counts[byte] < rank; byte++)
            rank -= counts[byte];
        found |= byte << shift;
    }
    float difference;
    memcpy(&difference, &found, sizeof difference);
    return difference;
}

bool dpl_measure_map(const struct dpl_image *image, const struct dpl_image *reference, bool fit, double noise,
                     struct dpl_measure *result, const struct dpl_log *log)
{
    if (!pair_check(image, reference, log))
        return false;
    size_t count = pair_count(image);
    double sum = 0, sum_reference = 0, squares = 0, squares_reference = 0, products = 0, errors = 0;
    for (size_t i = 0; i < count; i++) {
        double e = image->pixels[i], r = reference->pixels[i];
        sum += e;
        sum_reference += r;
        squares += e * e;
        squares_reference += r * r;
        products += e * r;
    }
    if (!(sum_reference > 0))
        return base_fail(log, DPL_REASON_RANGE, "reference: mean: \"%g\" (accepted: above 0)",
                         sum_reference / (double)count);
    double gain = !fit ? 1 : squares > 0 ? products / squares : 0;
    for (size_t i = 0; i < count; i++) {
        double difference = image->pixels[i] * gain - reference->pixels[i];
        errors += difference * difference;
    }
    *result = (struct dpl_measure){
        .error = sqrt(fmax(errors / squares_reference - noise * noise, 0)),
        .p99 = percentile(image, reference, gain, 0.99) / (sum_reference / (double)count),
        .energy = gain * sum / sum_reference,
        .gain = gain,
    };
    return true;
}
