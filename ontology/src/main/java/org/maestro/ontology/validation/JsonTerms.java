package org.maestro.ontology.validation;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The words that JSON-LD contexts define at a place of a text. Immutable.
 *
 * @param words keys that mean something
 * @param isOpen any key means something, by {@code @vocab}
 * @param opaque keys below which others than these are written, such as languages
 */
record JsonTerms(Set<String> words, boolean isOpen, Set<String> opaque) {

  static final JsonTerms NONE = new JsonTerms(Set.of(), false, Set.of());

  JsonTerms {
    words = Set.copyOf(words);
    opaque = Set.copyOf(opaque);
  }

  /**
   * With what an object's own context adds.
   *
   * @param ours what {@link SourceReader#CONTEXT_IRI} defines
   */
  JsonTerms with(JsonText.Members object, JsonText ours) {
    JsonTerms terms = this;
    for (JsonText context : object.value("@context").map(JsonText::each).orElse(List.of())) {
      terms = terms.withContext(context, ours);
    }
    return terms;
  }

  private JsonTerms withContext(JsonText context, JsonText ours) {
    if (context instanceof JsonText.Scalar scalar) {
      return scalar.text().equals(SourceReader.CONTEXT_IRI) ? withDefined(ours) : this;
    }
    return withDefined(context);
  }

  private JsonTerms withDefined(JsonText context) {
    if (!(context instanceof JsonText.Members members)) {
      return this;
    }
    Set<String> all = new LinkedHashSet<>(words);
    Set<String> closed = new LinkedHashSet<>(opaque);
    boolean open = isOpen;
    for (JsonText.Member member : members.all()) {
      all.add(member.key());
      if (member.value() instanceof JsonText.Members definition) {
        open |= definition.value("@context").isPresent();
        if (isOpaque(definition)) {
          closed.add(member.key());
        }
      }
      open |= member.key().equals("@vocab") || member.key().equals("@import");
    }
    return new JsonTerms(all, open, closed);
  }

  private static boolean isOpaque(JsonText.Members definition) {
    Optional<String> container = text(definition, "@container");
    return text(definition, "@type").filter("@json"::equals).isPresent()
        || container.filter(kind -> !kind.equals("@list") && !kind.equals("@set")).isPresent();
  }

  private static Optional<String> text(JsonText.Members definition, String key) {
    return definition
        .value(key)
        .map(value -> value instanceof JsonText.Scalar scalar ? scalar.text() : key);
  }

  /** Whether a key means something; one with a prefix is nobody's to judge. */
  boolean knows(String key) {
    return isOpen || key.startsWith("@") || key.contains(":") || words.contains(key);
  }
}
