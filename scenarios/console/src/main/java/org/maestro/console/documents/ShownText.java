package org.maestro.console.documents;

import java.util.regex.Pattern;
import org.maestro.text.VisibleText;

/** Text that others wrote, as it is shown: without secrets, without what would be obeyed. */
public final class ShownText {
  private static final String MASK = "•••";

  /** As JSON, as MAESTRO-SL, and as {@code name=value}. */
  private static final Pattern SECRET =
      Pattern.compile(
          "(?i)((?:pass(?:word|wd|phrase)|secret|token|credentials?|api[_-]?key|private[_-]?key)"
              + "[\\w-]*\"?(?:\\s*[:=]\\s*|\\s+))"
              + "(\"(?:[^\"\\\\]|\\\\.)*+\"?|[^\\s,;)}\\]\"]++)");

  private ShownText() {}

  /** In full. */
  public static String of(String text) {
    return VisibleText.lines(
        SECRET
            .matcher(text)
            .replaceAll(
                found -> found.group(1) + (found.group(2).startsWith("\"") ? quoted() : MASK)));
  }

  private static String quoted() {
    return '"' + MASK + '"';
  }

  /** Adds a text under a name, and whether it is shortened to a number of characters. */
  public static void add(JsonMembers row, String name, String text, int most) {
    String shown = of(text);
    row.node().put(name, cut(shown, most));
    row.truth("shortened", shown.length() > most);
  }

  public static String cut(String text, int most) {
    if (text.length() <= most) {
      return text;
    }
    return text.substring(0, Character.isHighSurrogate(text.charAt(most - 1)) ? most - 1 : most);
  }
}
