package org.maestro.language.chart;

import java.util.Optional;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Rule;
import org.maestro.language.grammar.Symbol;

/**
 * A rule of which the first symbols were heard.
 *
 * @param origin the column in which it begins
 * @param heard what they mean, the last first; empty at the beginning
 */
record Derivation(Rule rule, int dot, int origin, Optional<Heard> heard, int penalty) {
  /** What a symbol means, and those before it. */
  record Heard(Form form, Optional<Heard> before) {}

  static Derivation begun(Rule rule, int origin) {
    return new Derivation(rule, 0, origin, Optional.empty(), rule.penalty());
  }

  Derivation advanced(Form form, int more) {
    return new Derivation(
        rule, dot + 1, origin, Optional.of(new Heard(form, heard)), penalty + more);
  }

  boolean isComplete() {
    return dot == rule.symbols().size();
  }

  /** Whether more was heard of it than words that it names. */
  boolean isOfMoreThanWords() {
    return rule.symbols().subList(0, dot).stream().anyMatch(Symbol.Category.class::isInstance);
  }

  /** Whether this was heard last of it. */
  boolean isAfter(Symbol symbol) {
    return dot > 0 && rule.symbols().get(dot - 1).equals(symbol);
  }

  Symbol awaited() {
    return rule.symbols().get(dot);
  }

  /** What it means; with holes where nothing was heard. */
  Form form() {
    Form[] forms = new Form[dot];
    Optional<Heard> last = heard;
    for (int i = dot - 1; i >= 0; i--) {
      Heard one = last.orElseThrow();
      forms[i] = one.form();
      last = one.before();
    }
    return rule.template()
        .apply(
            label -> {
              int at = rule.labels().indexOf(label);
              return at < 0
                  ? Optional.empty()
                  : Optional.of(at < forms.length ? forms[at] : Form.HOLE);
            })
        .orElse(Form.HOLE);
  }
}
