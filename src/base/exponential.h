/* base/exponential.h: the exponential function in a form that the compiler makes vectors of. */
#ifndef BASE_EXPONENTIAL_H
#define BASE_EXPONENTIAL_H

#include "base/vector.h"

#include <stdint.h>
#include <string.h>

/* exp(x) within 1e-6 of its value for x from -87 to 87; beyond these ends that of the end. */
VECTOR_PART float exponential(float x)
{
    x = vector_clamp(x, -87.0f, 87.0f);
    float whole = rintf(x * 1.44269504f);                             /* exp(x) = 2^whole × exp(rest) */
    float rest = (x - whole * 0.693145752f) - whole * 1.42860677e-6f; /* ln 2 in two parts; |rest| ≤ 0.35 */
    float power =
        1.0f +
        rest * (1.0f + rest * (0.5f + rest * (1.0f / 6 + rest * (1.0f / 24 + rest * (1.0f / 120 + rest / 720)))));
    int32_t bits = ((int32_t)whole + 127) << 23;
    float scale;
    memcpy(&scale, &bits, sizeof scale);
    return power * scale;
}

#endif
