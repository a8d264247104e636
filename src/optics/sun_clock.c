/* NOAA's solar calculator (Global Monitoring Laboratory), which follows Meeus 1991, "Astronomical Algorithms". Names
 * and steps are those of its published spreadsheet. */
#include "optics/sun_clock.h"

#include <math.h>

static const double degree = M_PI / 180;

/* Days since noon of 1 January 4713 BC, at midnight before the date (Meeus 1991, eq. 7.1, Gregorian calendar). */
static double julian_day(const int date[3])
{
    int month = date[1] - 1, year = date[0] + month / 12;
    month = month % 12 + 1;
    if (month <= 2) {
        year -= 1;
        month += 12;
    }
    int century = year / 100;
    return floor(365.25 * (year + 4716)) + floor(30.6001 * (month + 1)) + date[2] + 2 - century + century / 4 - 1524.5;
}

/* Of the sun, in radians, and the minutes that a sundial is ahead of a clock. `t`: centuries since noon of 1 January
 * 2000. */
static void find_sun(double t, double *declination, double *equation_of_time)
{
    double mean_longitude = (280.46646 + t * (36000.76983 + t * 0.0003032)) * degree;
    double anomaly = (357.52911 + t * (35999.05029 - 0.0001537 * t)) * degree;
    double eccentricity = 0.016708634 - t * (0.000042037 + 0.0000001267 * t);
    double center = sin(anomaly) * (1.914602 - t * (0.004817 + 0.000014 * t)) +
                    sin(2 * anomaly) * (0.019993 - 0.000101 * t) + sin(3 * anomaly) * 0.000289;
    double node = (125.04 - 1934.136 * t) * degree;
    double longitude = mean_longitude + (center - 0.00569 - 0.00478 * sin(node)) * degree;
    double seconds = 21.448 - t * (46.815 + t * (0.00059 - t * 0.001813));
    double obliquity = (23 + (26 + seconds / 60) / 60 + 0.00256 * cos(node)) * degree;
    double y = tan(obliquity / 2) * tan(obliquity / 2);
    *declination = asin(sin(obliquity) * sin(longitude));
    *equation_of_time = 4 / degree *
                        (y * sin(2 * mean_longitude) - 2 * eccentricity * sin(anomaly) +
                         4 * eccentricity * y * sin(anomaly) * cos(2 * mean_longitude) -
                         0.5 * y * y * sin(4 * mean_longitude) - 1.25 * eccentricity * eccentricity * sin(2 * anomaly));
}

/* Degrees by which air lifts the sun. */
static double refraction(double elevation)
{
    double tangent = tan(elevation * degree), e = elevation, seconds = 0;
    if (elevation > 85)
        seconds = 0;
    else if (elevation > 5)
        seconds = 58.1 / tangent - 0.07 / pow(tangent, 3) + 0.000086 / pow(tangent, 5);
    else if (elevation > -0.575)
        seconds = 1735 + e * (-518.2 + e * (103.4 + e * (-12.79 + e * 0.711)));
    else
        seconds = -20.772 / tangent;
    return seconds / 3600;
}

void sun_clock_read(const struct sun_clock *clock, double *elevation, double *bearing)
{
    double universal = clock->hour - clock->time_zone, declination, equation_of_time;
    double century = (julian_day(clock->date) + universal / 24 - 2451545) / 36525;
    find_sun(century, &declination, &equation_of_time);
    double solar_time = universal * 60 + equation_of_time + 4 * clock->longitude; /* minutes */
    double hour_angle = (solar_time / 4 - 180) * degree, latitude = clock->latitude * degree;
    double up = sin(latitude) * sin(declination) + cos(latitude) * cos(declination) * cos(hour_angle);
    double north = cos(latitude) * sin(declination) - sin(latitude) * cos(declination) * cos(hour_angle);
    double east = -cos(declination) * sin(hour_angle);
    double geometric = atan2(up, hypot(north, east)) / degree;
    *elevation = geometric + refraction(geometric);
    *bearing = atan2(east, north) / degree;
    if (*bearing < 0)
        *bearing += 360;
}
