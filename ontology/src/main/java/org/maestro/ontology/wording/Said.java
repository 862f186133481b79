package org.maestro.ontology.wording;

/**
 * A text in a language of people.
 *
 * @param language its tag, such as {@code en}; "" when it counts for all
 */
public record Said(String text, String language) {
  /**
   * Whether it is said in that language, in whichever country; in a country's own also what is said
   * everywhere.
   */
  public boolean isIn(String tag) {
    return language.isEmpty()
        || language.equals(tag)
        || language.startsWith(tag + "-")
        || tag.startsWith(language + "-");
  }

  /** Another text in the same language. */
  public Said saying(String other) {
    return new Said(other, language);
  }
}
