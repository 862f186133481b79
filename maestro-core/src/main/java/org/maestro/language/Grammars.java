package org.maestro.language;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Pattern;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.GrammarFaultException;
import org.maestro.language.grammar.GrammarReader;
import org.maestro.ontology.home.Home;

/**
 * The grammars of a home: those that it brings as files (A95), before those that are shipped.
 * Stateless, safe for threads.
 */
final class Grammars {
  private static final String ENDING = ".grammar";
  private static final String REPORTS = ".reports";

  /** The language that is never without a phrase. */
  private static final String WHOLE = "en";

  private static final Pattern TAG = Pattern.compile("[a-z]{2,3}(-[A-Za-z]{2,4})?");

  private Grammars() {}

  /** Whether somebody can be understood at home in the language of that tag. */
  static boolean has(Home home, String tag) {
    return home.wording().grammars().containsKey(tag) || isShipped(tag);
  }

  /** The grammar of a language that the home has. */
  static Grammar of(Home home, String tag) {
    String own = home.wording().grammars().get(tag);
    return own == null ? shipped(tag) : read(own, tag + ENDING);
  }

  /**
   * Reads those that the home brings.
   *
   * @throws GrammarFaultException when a line of one cannot be read, or something is missing
   */
  static void check(Home home) {
    Grammar whole = shipped(WHOLE);
    home.wording()
        .grammars()
        .forEach(
            (tag, text) -> {
              Grammar own = read(text, tag + ENDING);
              if (!own.language().equals(tag)) {
                throw new GrammarFaultException(
                    tag + ENDING,
                    1,
                    "is the grammar of " + own.language(),
                    "name the file %s%s, or write language %s in it"
                        .formatted(own.language(), ENDING, tag));
              }
              own.firstMissing(whole)
                  .ifPresent(
                      phrase -> {
                        throw new GrammarFaultException(
                            tag + ENDING,
                            1,
                            "has no phrase " + phrase,
                            "write it, or have those that are missing from a shipped grammar by a"
                                + " line such as phrases like en");
                      });
            });
  }

  /** A grammar that may be built on a shipped one. */
  static Grammar read(String text, String file) {
    return GrammarReader.read(
        text, file, tag -> Optional.of(tag).filter(Grammars::isShipped).map(Grammars::whole));
  }

  private static String whole(String tag) {
    return text(tag + ENDING) + "\n" + (isThere(tag + REPORTS) ? text(tag + REPORTS) : "");
  }

  static Grammar shipped(String tag) {
    if (!isShipped(tag)) {
      throw new IllegalArgumentException(
          "There is no grammar for the language %s; name one that is shipped, such as de, or a file such as nl.grammar."
              .formatted(tag));
    }
    Grammar grammar = GrammarReader.read(text(tag + ENDING), tag + ENDING);
    return isThere(tag + REPORTS)
        ? grammar.withReports(GrammarReader.read(text(tag + REPORTS), tag + REPORTS))
        : grammar;
  }

  private static boolean isShipped(String tag) {
    return TAG.matcher(tag).matches() && isThere(tag + ENDING);
  }

  private static boolean isThere(String file) {
    return Grammars.class.getResource(file) != null;
  }

  private static String text(String file) {
    try (InputStream stream = Grammars.class.getResourceAsStream(file)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException("The file " + file + " cannot be read.", e);
    }
  }
}
