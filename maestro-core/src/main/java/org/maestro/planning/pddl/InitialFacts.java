package org.maestro.planning.pddl;

import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.maestro.planning.pddl.Expression.Group;
import org.maestro.planning.pddl.Expression.Word;

/** The facts of a problem's beginning, and which of them no action changes. */
final class InitialFacts {
  private final Symbols symbols;
  private final Set<String> facts = new HashSet<>();
  private final Set<String> changing = new HashSet<>();

  /** What is known of a fact without looking at a state. */
  enum Known {
    HOLDS,
    LACKS,
    CHANGES
  }

  InitialFacts(Symbols symbols, List<Expression> initial, List<Expression> effects) {
    this.symbols = symbols;
    initial.forEach(fact -> facts.add(fact.text()));
    effects.forEach(this::addChanging);
  }

  private void addChanging(Expression effect) {
    if (effect instanceof Group group) {
      switch (group.head()) {
        case "and", "not" -> group.rest().forEach(this::addChanging);
        case "when", "forall" -> group.items().stream().skip(2).forEach(this::addChanging);
        default -> changing.add(group.head());
      }
    }
  }

  /** Whether no action changes it. */
  boolean isStatic(String predicate) {
    return !changing.contains(predicate);
  }

  /** An atom of wrong things never holds: a variable that stands for them is of a wider type. */
  Known known(Group atom) {
    List<List<String>> types = Objects.requireNonNull(symbols.predicates.get(atom.head())).types();
    boolean ground = true;
    for (int i = 0; i < types.size(); i++) {
      Word argument = (Word) atom.rest().get(i);
      if (argument.isVariable()) {
        ground = false;
      } else if (!symbols.isOfType(symbols.object(argument), types.get(i))) {
        return Known.LACKS;
      }
    }
    if (!ground || !isStatic(atom.head())) {
      return Known.CHANGES;
    }
    return facts.contains(atom.text()) ? Known.HOLDS : Known.LACKS;
  }
}
