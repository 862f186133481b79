package org.maestro.rats.transport;

import java.util.List;

/**
 * An MQTT topic filter: {@code +} stands for one level, {@code #} at the end for the parent and all
 * below.
 */
record TopicFilter(String text, List<String> levels, int firstWildcard, String before) {

  static TopicFilter of(String text) {
    List<String> levels = List.of(text.split("/", -1));
    for (int index = 0; index < levels.size(); index++) {
      String level = levels.get(index);
      boolean wildcardInside = level.length() > 1 && (level.contains("+") || level.contains("#"));
      boolean hashBeforeTheEnd = level.equals("#") && index < levels.size() - 1;
      if (text.isEmpty() || wildcardInside || hashBeforeTheEnd) {
        throw new IllegalArgumentException(
            "'" + text + "' is no topic filter: + takes a whole level, # the last one");
      }
    }
    int wildcard = firstWildcard(text);
    // most topics are told apart by what stands before; a/# is for a, too
    return new TopicFilter(text, levels, wildcard, text.substring(0, Math.max(0, wildcard - 1)));
  }

  private static int firstWildcard(String text) {
    int plus = text.indexOf('+');
    int hash = text.indexOf('#');
    return plus < 0 || hash < 0 ? Math.max(plus, hash) : Math.min(plus, hash);
  }

  boolean hasWildcard() {
    return firstWildcard >= 0;
  }

  boolean matches(String topic) {
    if (!hasWildcard()) {
      return text.equals(topic);
    }
    if (!topic.startsWith(before)) {
      return false;
    }
    int start = 0;
    for (int index = 0; index < levels.size(); index++) {
      String level = levels.get(index);
      if (level.equals("#")) {
        return true;
      }
      if (start > topic.length()) {
        return false;
      }
      int end = end(topic, start);
      boolean fits =
          level.equals("+") || level.length() == end - start && topic.startsWith(level, start);
      if (!fits) {
        return false;
      }
      boolean onlyHashFollows = index == levels.size() - 2 && levels.get(index + 1).equals("#");
      if (end == topic.length() && onlyHashFollows) {
        return true;
      }
      start = end + 1;
    }
    return start > topic.length();
  }

  private static int end(String topic, int start) {
    int slash = topic.indexOf('/', start);
    return slash < 0 ? topic.length() : slash;
  }
}
