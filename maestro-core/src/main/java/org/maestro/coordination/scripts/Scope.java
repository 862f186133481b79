package org.maestro.coordination.scripts;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.sl.AnswerFormat;
import org.maestro.sl.Content;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * What variables stand for at one place of a script.
 *
 * @param depth of scripts that run each other
 */
record Scope(Map<String, Term> values, int depth) {
  Scope {
    values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
  }

  Scope with(String variable, Term value) {
    Map<String, Term> more = new LinkedHashMap<>(values);
    more.put(variable, value);
    return new Scope(more, depth);
  }

  private Substitution substitution() {
    return new Substitution(values);
  }

  Term apply(Term term) {
    return substitution().apply(term);
  }

  List<Term> apply(List<Term> terms) {
    return terms.stream().map(this::apply).toList();
  }

  AnswerFormat apply(AnswerFormat format) {
    return format instanceof AnswerFormat.Choice choice
        ? new AnswerFormat.Choice(apply(choice.options()))
        : format;
  }

  Content apply(Content content) {
    return substitution().apply(content);
  }

  Formula apply(Formula formula) {
    return substitution().apply(formula);
  }

  Effect apply(Effect effect) {
    return substitution().apply(effect);
  }

  Expression apply(Expression expression) {
    return substitution().apply(expression);
  }
}
