/* optics/sun_clock.h: where the sun stands at a time and a place. */
#ifndef OPTICS_SUN_CLOCK_H
#define OPTICS_SUN_CLOCK_H

struct sun_clock {
    const int *date;            /* year, month, day; months and days beyond the last one count on */
    double hour;                /* of the local clock */
    double time_zone;           /* hours that the local clock is ahead of universal time */
    double latitude, longitude; /* degrees, north and east */
};

/* Degrees: height of the sun's middle above the horizon as it is seen through the air, and its bearing from north
 * towards east. Within 0.02° of others' results (tests/sun_clock.c), apart from what the weather does to the lowest
 * degree. */
void sun_clock_read(const struct sun_clock *clock, double *elevation, double *bearing);

#endif
