/* JSON, read where it lies and written nowhere: a text is the part of a message from `at` to `end`. */
#ifndef JSON_H
#define JSON_H
#include <stdbool.h>

enum { MOST_DEPTH = 16 }; /* of objects and lists in each other, as on the whole bus */

typedef struct {
  const char *at, *end;
} Text;

bool text_is(Text text, const char *word);
bool text_same(Text one, Text other);
int text_length(Text text);
bool one_of(const char *set, char c);
bool is_digit(char c);
bool is_letter(char c);

/* Takes that character, if it is the next that is no blank. */
bool json_next(Text *in, char wanted);

/* Takes a value so deep in others; false where there is none, or half a character in it. */
bool json_value(Text *in, int depth, Text *whole);

/* The field of an object, which may be broken behind it. */
bool json_field(Text object, const char *name, Text *found);

/* The same of one that is a text; its escapes are left as they are. */
bool json_text(Text object, const char *name, Text *content);
#endif
