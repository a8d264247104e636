#include "cli/interrupt.h"

#include <signal.h>
#include <stddef.h>

/* A signal handler gets no argument of the program's: these two cannot live in a function. */
static volatile sig_atomic_t held, caught;

static void end_by(int number)
{
    signal(number, SIG_DFL);
    raise(number);
}

static void handle(int number)
{
    if (held)
        caught = number;
    else
        end_by(number);
}

void interrupt_install(void)
{
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action = {.sa_handler = handle};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        struct sigaction before;
        sigaction(numbers[i], NULL, &before);
        if (before.sa_handler != SIG_IGN) /* as nohup and shells in the background want it */
            sigaction(numbers[i], &action, NULL);
    }
}

void interrupt_hold(void)
{
    held++;
}

void interrupt_release(void)
{
    held--;
    if (caught && !held)
        end_by(caught);
}

bool interrupt_caught(void)
{
    return caught != 0;
}
