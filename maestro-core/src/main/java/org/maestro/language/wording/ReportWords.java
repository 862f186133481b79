package org.maestro.language.wording;

import java.util.Optional;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * Reports of who speaks of things by their ids, and of what is so in MAESTRO-SL, such as the
 * sentences of goals' stories, as they are said to people: in a language that has rules for reports
 * by these, else in the words in which they were written. Immutable.
 */
public final class ReportWords {
  private final Home home;
  private final Naming naming;
  private final FactWords facts;
  private final Optional<TranslatedReports> translated;

  /**
   * In a language.
   *
   * @param listener the person who is spoken to, by her name in the home
   */
  public ReportWords(Home home, Grammar grammar, Optional<String> listener) {
    this.home = home;
    this.naming = new Naming(home, grammar);
    this.facts = new FactWords(home, grammar, listener);
    this.translated =
        grammar.reports().isEmpty()
            ? Optional.empty()
            : Optional.of(new TranslatedReports(home, grammar, this::fact));
  }

  /** One or more sentences. */
  public String of(String report) {
    return translated
        .map(translation -> Phrases.capitalized(translation.of(report)))
        .orElseGet(() -> inTheSameWords(report));
  }

  private String inTheSameWords(String report) {
    StringBuilder said = new StringBuilder();
    int at = 0;
    while (at < report.length()) {
      int open = report.indexOf('(', at);
      int end = open < 0 ? -1 : closing(report, open);
      if (end < 0) {
        break;
      }
      Optional<String> fact = fact(report.substring(open, end));
      said.append(naming.inText(report.substring(at, open)));
      if (fact.isPresent()) {
        said.append(fact.get());
        at = end;
      } else {
        said.append('(');
        at = open + 1;
      }
    }
    return Phrases.capitalized(said + naming.inText(report.substring(at)));
  }

  /** Behind the bracket that closes the one there; -1 when none does. */
  private static int closing(String text, int open) {
    int depth = 0;
    for (int i = open; i < text.length(); i++) {
      depth += text.charAt(i) == '(' ? 1 : text.charAt(i) == ')' ? -1 : 0;
      if (depth == 0) {
        return i + 1;
      }
    }
    return -1;
  }

  private Optional<String> fact(String text) {
    try {
      Formula formula = SlParser.formula(text, home.vocabulary()::isFluent);
      return Optional.of(formula).filter(this::isOfTheHome).flatMap(facts::of);
    } catch (SlSyntaxException e) {
      return Optional.empty();
    }
  }

  /** What only looks like a formula has other words. */
  private boolean isOfTheHome(Formula formula) {
    boolean[] all = {true};
    Leaves.of(
        formula,
        atom -> all[0] &= isKnown(atom.predicate(), atom.arguments().size()),
        fluent -> all[0] &= isKnown(fluent.name(), fluent.arguments().size()));
    return all[0];
  }

  private boolean isKnown(String name, int arguments) {
    return arguments == 1 && home.vocabulary().classes().containsKey(name)
        || home.vocabulary()
            .predicate(name)
            .filter(predicate -> predicate.parameters().size() == arguments)
            .isPresent();
  }
}
