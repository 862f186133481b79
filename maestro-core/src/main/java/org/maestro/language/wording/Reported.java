package org.maestro.language.wording;

/**
 * A report, or a part of one, in another language than the one that it was written in.
 *
 * @param text as it is said
 * @param symbol as it stands in MAESTRO-SL; "" for what does not
 * @param foreign how many characters of it are said as they were written
 */
record Reported(String text, String symbol, int foreign) {
  static Reported of(String text) {
    return new Reported(text, "", 0);
  }

  /** Something that has a name in MAESTRO-SL, too. */
  static Reported named(String text, String symbol) {
    return new Reported(text, symbol, 0);
  }
}
