#include "optics/sky.h"
#include <math.h>
void optics_sky_radiance(const struct optics_sky *sky, const double d[3], double radiance[3]){
 int row=(int)fmin(acos(fmin(fmax(d[1],-1),1))/M_PI*SKY_ROWS,SKY_ROWS-1); double a=atan2(d[2],d[0])/(2*M_PI); a-=floor(a);
 int col=(int)fmin(a*SKY_COLUMNS,SKY_COLUMNS-1);
 for(int c=0;c<3;c++) radiance[c]=(double)sky->texels[(row*SKY_COLUMNS+col)*3+c];}
