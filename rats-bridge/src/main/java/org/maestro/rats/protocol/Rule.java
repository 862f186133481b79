package org.maestro.rats.protocol;

import java.util.regex.Pattern;

/**
 * The pattern that a text of a message has to match, with the words that say so. The JSON Schemas
 * hold the same patterns.
 */
enum Rule {
  /** Becomes a level of a topic. */
  NAME(
      "[A-Za-z0-9][A-Za-z0-9._-]{0,62}", "a name of letters, digits, '.', '_' and '-', at most 63"),
  VERSION("[0-9]{1,6}\\.[0-9]{1,6}", "a text such as \"" + WireFormat.VERSION + "\""),
  FEATURE("[^/+#\\s\\p{Cntrl}]{1,128}", "1 to 128 characters without space, '/', '+' and '#'"),
  WORD("[A-Z][A-Z0-9_]{0,62}", "a word of capital letters, digits and '_', at most 63"),
  ID("[^\\s\\p{Cntrl}]{1,128}", "1 to 128 characters without space"),
  MEDIA_TYPE(
      "(?=.{1,127}$)[a-z]+/[A-Za-z0-9.+-]+(;[a-z0-9-]+=[A-Za-z0-9.+-]+)*",
      "a media type such as image/png, of at most 127 characters"),
  DATA("[A-Za-z0-9+/]{0,253336}+={0,2}", "base64 of at most 190000 bytes"),
  TEXT("(?s).{0,8192}", "a text of at most 8192 characters");

  private final Pattern pattern;
  private final String words;

  Rule(String pattern, String words) {
    this.pattern = Pattern.compile(pattern);
    this.words = words;
  }

  boolean allows(String text) {
    return pattern.matcher(text).matches();
  }

  String words() {
    return words;
  }
}
