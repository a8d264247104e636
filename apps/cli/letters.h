/* cli/letters.h: the shapes of printable ASCII, for text in pictures. */
#ifndef CLI_LETTERS_H
#define CLI_LETTERS_H

#include <stdbool.h>

/* Pixels of a letter; the last two rows lie below the line. */
#define LETTER_WIDTH 5
#define LETTER_HEIGHT 9

/* Whether a pixel of the letter is set. What is not printable ASCII looks like a question mark. */
bool letter_pixel(char letter, int x, int y);

#endif
