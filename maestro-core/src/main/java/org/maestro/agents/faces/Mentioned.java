package org.maestro.agents.faces;

import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;

/** The things of a home that a sentence speaks of, by what they are called. */
final class Mentioned {
  private static final String THING = "Thing";

  private Mentioned() {}

  /** The one that is named first; of two names that begin at one place, the longer. */
  static Optional<String> first(String sentence, Home home) {
    String text = sentence.toLowerCase(Locale.ROOT);
    return home.individuals().values().stream()
        .filter(one -> home.devices().containsKey(one.name()) || one.classes().contains(THING))
        .filter(one -> at(text, one) >= 0)
        .min(
            Comparator.<Individual>comparingInt(one -> at(text, one))
                .thenComparing(one -> -one.label().length())
                .thenComparing(Individual::name))
        .map(Individual::name);
  }

  private static int at(String text, Individual one) {
    String label = one.label().toLowerCase(Locale.ROOT);
    int at = label.isBlank() ? -1 : text.indexOf(label);
    boolean isWhole =
        at >= 0
            && (at == 0 || !Character.isLetter(text.charAt(at - 1)))
            && (at + label.length() == text.length()
                || !Character.isLetter(text.charAt(at + label.length())));
    return isWhole ? at : -1;
  }
}
