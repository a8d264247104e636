/* cli/interrupt.h: SIGINT, SIGTERM and SIGHUP end the program, but never in the middle of a file. */
#ifndef CLI_INTERRUPT_H
#define CLI_INTERRUPT_H

#include <stdbool.h>

/* Once, at the start. */
void interrupt_install(void);

/* Between these two a signal only raises the flag that interrupt_caught() returns, and a blocking call returns EINTR;
 * interrupt_release() then ends the program by it. Pairs may stand within pairs: the outermost counts. */
void interrupt_hold(void);
void interrupt_release(void);
bool interrupt_caught(void);

#endif
