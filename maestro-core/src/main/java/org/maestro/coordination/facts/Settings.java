package org.maestro.coordination.facts;

import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import org.maestro.planning.api.Step;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/** Numbers of members that steps assign, such as the level of a lamp. */
public final class Settings {
  private Settings() {}

  /** The numbers of the member itself that the step assigns. */
  public static Set<Expression.Fluent> assigned(Step step) {
    Map<String, Term> bindings = step.values();
    Set<Expression.Fluent> assigned = new LinkedHashSet<>();
    collect(step.feature().effect(), new Substitution(bindings), step.member(), assigned);
    return assigned;
  }

  private static void collect(
      Effect effect, Substitution bindings, String member, Set<Expression.Fluent> assigned) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(part, bindings, member, assigned));
    } else if (effect instanceof Effect.When when) {
      collect(when.effect(), bindings, member, assigned);
    } else if (effect instanceof Effect.Change change
        && change.assignment() == Effect.Assignment.ASSIGN) {
      Expression.Fluent fluent = bindings.apply(change.fluent());
      if (fluent.arguments().contains(new Term.Name(member))) {
        assigned.add(fluent);
      }
    }
  }
}
