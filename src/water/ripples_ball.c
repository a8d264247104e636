#include "water/ripples_ball.h"

#include <math.h>

#define VOLUME_MAX 3 /* of (1.5 distance / radius)²: b = exp(-its cube) is then e⁻²⁷, and nothing beyond */

double ball_reach(const struct ball *ball)
{
    return ball->radius * sqrt(VOLUME_MAX) / 1.5;
}

/* Wallace's volume is 0.1 (high - low) with low = min(0, y - b) and high = min(max(0, y + b), low + 2 b), y the height
 * of the ball's middle; whatever y and b are, that is 0.2 b. In his units b does not depend on the radius. */
float ball_volume(const struct ball *ball, const struct ball_pool *pool, double x, double z)
{
    if (!(ball->radius > 0))
        return 0;
    float from_x = (float)((x - ball->center[0]) / ball->radius);
    float from_y = (float)(ball->center[1] / ball->radius);
    float from_z = (float)((z - ball->center[2]) / ball->radius);
    float squared = 2.25f * (from_x * from_x + from_y * from_y + from_z * from_z);
    if (squared > VOLUME_MAX)
        return 0;
    return 0.2f * expf(-squared * squared * squared) * (float)pool->half;
}

void ball_move(struct ball *ball, const struct ball_pool *pool, double velocity[3])
{
    double below = ball->radius - ball->center[1];
    double submerged = below <= 0 ? 0 : fmin(below / (2 * ball->radius), 1);
    velocity[1] -= pool->gravity * BALL_TICK * (1 - 1.1 * submerged);
    double speed = sqrt(velocity[0] * velocity[0] + velocity[1] * velocity[1] + velocity[2] * velocity[2]);
    double drag = fmin(submerged * speed / pool->half * BALL_TICK, 1); /* stops it at most */
    for (int c = 0; c < 3; c++) {
        velocity[c] *= 1 - drag;
        ball->center[c] += velocity[c] * BALL_TICK;
    }
    if (ball->center[1] < ball->radius - pool->depth) {
        ball->center[1] = ball->radius - pool->depth;
        velocity[1] = 0.7 * fabs(velocity[1]);
    }
}
