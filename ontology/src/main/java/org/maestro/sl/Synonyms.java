package org.maestro.sl;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The words of one speaker, predicates, numbers and classes, that others call otherwise.
 *
 * @param commonWords by the speaker's own word
 */
public record Synonyms(Map<String, String> commonWords) {

  /** Of a speaker who speaks as all do. */
  public static final Synonyms NONE = new Synonyms(Map.of());

  private static final String CLASS_FOLLOWS = "-";

  public Synonyms {
    commonWords = Collections.unmodifiableMap(new TreeMap<>(commonWords));
  }

  /**
   * What the speaker says, in the words that all use; a text that is no MAESTRO-SL stays as it is.
   */
  public String translated(String text) {
    if (commonWords.isEmpty()) {
      return text;
    }
    StringBuilder translated = new StringBuilder(text);
    try {
      List<Node> nodes = SlReader.readAll(text, "an expression");
      TreeMap<Integer, String> found = new TreeMap<>(Collections.reverseOrder());
      nodes.stream()
          .filter(Node.Group.class::isInstance)
          .forEach(node -> words((Node.Group) node, found));
      classes(nodes, found);
      found.forEach(
          (column, word) ->
              translated.replace(
                  column - 1, column - 1 + word.length(), commonWords.getOrDefault(word, word)));
    } catch (SlSyntaxException noSl) {
      return text;
    }
    return translated.toString();
  }

  /** A word of the speaker that stands for one of the other's, who says so the other way round. */
  public Optional<String> crossing(Synonyms other) {
    return commonWords.entrySet().stream()
        .filter(entry -> entry.getKey().equals(other.commonWords.get(entry.getValue())))
        .map(Map.Entry::getKey)
        .findFirst();
  }

  /** The common word for one of the speaker's own that is another. */
  public Optional<String> common(String own) {
    return Optional.ofNullable(commonWords.get(own));
  }

  /** A common word with how the speaker calls it, where that differs. */
  public String asSaid(String word) {
    return commonWords.entrySet().stream()
        .filter(entry -> entry.getValue().equals(word))
        .map(entry -> word + " (in its own words " + entry.getKey() + ")")
        .findFirst()
        .orElse(word);
  }

  private static void words(Node.Group group, Map<Integer, String> found) {
    if (!group.head().isEmpty()) {
      found.put(group.children().get(0).column(), group.head());
    }
    classes(group.children(), found);
    for (Node child : group.children()) {
      if (child instanceof Node.Group inner) {
        words(inner, found);
      }
    }
  }

  /** The classes in a list of typed variables. */
  private static void classes(List<Node> nodes, Map<Integer, String> found) {
    for (int i = 2; i < nodes.size(); i++) {
      if (isWord(nodes.get(i - 1), CLASS_FOLLOWS) && nodes.get(i) instanceof Node.Leaf type) {
        found.put(type.column(), type.text());
      }
    }
  }

  private static boolean isWord(Node node, String word) {
    return node instanceof Node.Leaf leaf
        && leaf.kind() == Node.Kind.WORD
        && leaf.text().equals(word);
  }
}
