#include "json.h"

#include <string.h>

bool text_is(Text text, const char *word) {
  size_t length = strlen(word);
  return (size_t)(text.end - text.at) == length && memcmp(text.at, word, length) == 0;
}

bool text_same(Text one, Text other) {
  return text_length(one) == text_length(other) && memcmp(one.at, other.at, (size_t)text_length(one)) == 0;
}

int text_length(Text text) { return (int)(text.end - text.at); }

bool one_of(const char *set, char c) { return c != 0 && strchr(set, c) != NULL; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

static void skip_blanks(Text *in) {
  while (in->at < in->end && one_of(" \t\r\n", *in->at)) in->at++;
}

bool json_next(Text *in, char wanted) {
  skip_blanks(in);
  bool found = in->at < in->end && *in->at == wanted;
  if (found) in->at++;
  return found;
}

static int utf16(Text *in) { /* of \uXXXX; -1 where there is none */
  int number = 0;
  if (in->end - in->at < 6 || in->at[0] != '\\' || in->at[1] != 'u') return -1;
  for (int i = 2; i < 6; i++) {
    const char *digits = "0123456789abcdef", *digit = digits;
    while (*digit != 0 && *digit != (is_letter(in->at[i]) ? in->at[i] | 0x20 : in->at[i])) digit++;
    if (*digit == 0) return -1;
    number = number * 16 + (int)(digit - digits);
  }
  in->at += 6;
  return number;
}

static bool escape(Text *in) {
  if (in->end - in->at < 2) return false;
  if (in->at[1] != 'u') {
    in->at += 2;
    return one_of("\"\\/bfnrt", in->at[-1]);
  }
  int first = utf16(in);
  if (first < 0xd800 || first > 0xdfff) return first >= 0;
  int second = first < 0xdc00 ? utf16(in) : -1; /* without it, it is half a character */
  return second >= 0xdc00 && second <= 0xdfff;
}

static bool utf8(Text *in) {
  unsigned char lead = (unsigned char)*in->at++;
  int more = lead < 0x80 ? 0 : lead < 0xc2 ? -1 : lead < 0xe0 ? 1 : lead < 0xf0 ? 2 : lead < 0xf5 ? 3 : -1;
  for (; more > 0 && in->at < in->end && ((unsigned char)*in->at & 0xc0) == 0x80; more--) in->at++;
  return more == 0;
}

static bool string(Text *in, Text *content) {
  if (!json_next(in, '"')) return false;
  content->at = in->at;
  while (in->at < in->end && *in->at != '"') {
    if ((unsigned char)*in->at < 0x20 || !(*in->at == '\\' ? escape(in) : utf8(in))) return false;
  }
  content->end = in->at;
  return json_next(in, '"');
}

static bool word(Text *in) { /* a number, true, false or null */
  Text found = {in->at, in->at};
  while (in->at < in->end && (is_letter(*in->at) || is_digit(*in->at) || one_of("+-.", *in->at))) in->at++;
  found.end = in->at;
  if (found.at == found.end) return false;
  if (is_digit(*found.at) || *found.at == '-') return true;
  return text_is(found, "true") || text_is(found, "false") || text_is(found, "null");
}

bool json_value(Text *in, int depth, Text *whole) {
  Text part;
  skip_blanks(in);
  whole->at = in->at;
  bool right = true, is_object = in->at < in->end && *in->at == '{';
  if (in->at < in->end && *in->at == '"') {
    right = string(in, &part);
  } else if (json_next(in, '{') || json_next(in, '[')) {
    char close = is_object ? '}' : ']';
    if (depth >= MOST_DEPTH) return false;
    if (!json_next(in, close)) {
      do right = (!is_object || (string(in, &part) && json_next(in, ':'))) && json_value(in, depth + 1, &part);
      while (right && json_next(in, ','));
      right = right && json_next(in, close);
    }
  } else {
    right = word(in);
  }
  whole->end = in->at;
  return right;
}

bool json_field(Text object, const char *name, Text *found) {
  Text key;
  if (!json_next(&object, '{')) return false;
  do {
    if (!string(&object, &key) || !json_next(&object, ':') || !json_value(&object, 1, found)) return false;
    if (text_is(key, name)) return true;
  } while (json_next(&object, ','));
  return false;
}

bool json_text(Text object, const char *name, Text *content) {
  Text whole;
  return json_field(object, name, &whole) && string(&whole, content);
}
