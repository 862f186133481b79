package org.maestro.coordination.scripts;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** A sentence for people, made of texts, and of things and numbers as people call them. */
final class Sentence {
  private static final int DECIMALS = 2;
  private static final String CLOSING = ".,;:!?";

  private Sentence() {}

  /** A blank stands between two words, but none before a mark that closes. */
  static String of(List<Term> words, Home home) {
    StringBuilder sentence = new StringBuilder();
    for (Term word : words) {
      String text = text(word, home);
      if (!sentence.isEmpty() && !text.isEmpty() && CLOSING.indexOf(text.charAt(0)) < 0) {
        sentence.append(' ');
      }
      sentence.append(text);
    }
    return sentence.toString();
  }

  /** As it can be written down for programs: of a text the text alone, of a thing its name. */
  static String plain(Term term) {
    if (term instanceof Term.Text text) {
      return text.value();
    }
    return term instanceof Term.Name name ? name.text() : SlPrinter.print(term);
  }

  private static String text(Term word, Home home) {
    if (word instanceof Term.Text text) {
      return text.value();
    } else if (word instanceof Term.Name name) {
      return Optional.ofNullable(home.individuals().get(name.text()))
          .map(Individual::label)
          .orElse(name.text());
    } else if (word instanceof Term.Number number && Double.isFinite(number.value())) {
      return SlPrinter.print(
          BigDecimal.valueOf(number.value())
              .setScale(DECIMALS, RoundingMode.HALF_UP)
              .doubleValue());
    }
    return SlPrinter.print(word);
  }
}
