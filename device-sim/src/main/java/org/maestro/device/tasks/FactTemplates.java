package org.maestro.device.tasks;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.sl.Fact;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * The facts that a device's own words mean: templates of its description, with {@code ?self} and
 * other variables to fill in.
 */
public final class FactTemplates {

  private final Term.Name self;
  private final Map<String, Fact> templates = new TreeMap<>();

  /**
   * @param facts MAESTRO-SL by the device's own word
   */
  public FactTemplates(String self, Map<String, String> facts) {
    this.self = new Term.Name(self);
    facts.forEach((word, fact) -> templates.put(word, SlParser.fact(fact)));
  }

  /**
   * The fact that the word means, with these values for its variables; empty when the description
   * does not say.
   */
  Optional<String> fact(String word, Map<String, Term> values) {
    return Optional.ofNullable(templates.get(word))
        .map(template -> SlPrinter.print(filled(template, values)));
  }

  /**
   * The fact that this value of the word means; a false truth value of a plain atom is its
   * negation.
   */
  public Optional<String> statement(String word, Term value) {
    return Optional.ofNullable(templates.get(word))
        .map(
            template -> {
              if (template instanceof Fact.Holds holds && value instanceof Term.Truth truth) {
                Fact stated = truth.value() ? holds : new Fact.Excluded(holds.atom());
                return SlPrinter.print(filled(stated, Map.of()));
              }
              return SlPrinter.print(filled(template, Map.of(word, value)));
            });
  }

  /** The plain fact that the word means of this value, or its negation. */
  public Optional<String> statement(String word, Term value, boolean so) {
    return Optional.ofNullable(templates.get(word))
        .filter(Fact.Holds.class::isInstance)
        .map(template -> ((Fact.Holds) template).atom())
        .map(atom -> so ? new Fact.Holds(atom) : new Fact.Excluded(atom))
        .map(fact -> SlPrinter.print(filled(fact, Map.of(word, value))));
  }

  private Fact filled(Fact template, Map<String, Term> values) {
    Map<String, Term> all = new TreeMap<>(values);
    all.put(Self.NAME, self);
    return new Substitution(all).apply(template);
  }
}
