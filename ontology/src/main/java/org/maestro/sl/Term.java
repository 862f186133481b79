package org.maestro.sl;

/** An argument of an atom: a variable, a named individual, an IRI or a literal value. */
public sealed interface Term {

  /** A variable; {@code name} is without the question mark. */
  record Variable(String name) implements Term {

    /** Whether a variable can have this name; a keyword can then, too. */
    public static boolean isName(String text) {
      return SlReader.isName(text);
    }
  }

  /** A bare name of an individual, such as {@code Cup} or {@code zone-b}. */
  record Name(String text) implements Term {

    /**
     * Spelled out because names are compared more than anything else: what a record has of itself
     * is many times slower until it is compiled.
     */
    @Override
    public boolean equals(Object other) {
      return other instanceof Name name && name.text.equals(text);
    }

    /**
     * Mixed, since names that are numbered through, such as {@code zone-12} and {@code cam-21},
     * have sums in lists of them that are the same for very many: maps of those became long chains.
     */
    @Override
    public int hashCode() {
      int hash = text.hashCode() * 0x85ebca6b;
      hash = (hash ^ hash >>> 15) * 0xc2b2ae35;
      return hash ^ hash >>> 16;
    }
  }

  /** A full IRI, written between angle brackets. */
  record Iri(String text) implements Term {}

  record Number(double value) implements Term {}

  /**
   * A quoted string; a position or pose is written so too: {@code "2.1 0.4 0.1"}, metres and
   * degrees.
   */
  record Text(String value) implements Term {}

  record Truth(boolean value) implements Term {}

  /**
   * A text of others that is meant as a name; what the language cannot write as one stays a text,
   * so that it cannot pass for more than one word, nor {@code 007} for the number 7. The words
   * {@code true} and {@code false} are read as truths, which are written the same.
   */
  static Term named(String text) {
    return SlReader.isName(text) && !SlReader.isNumber(text) ? new Name(text) : new Text(text);
  }

  default boolean isGround() {
    return !(this instanceof Variable);
  }
}
