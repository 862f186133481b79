package org.maestro.agents;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.coordination.api.Reasoner;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/**
 * A small rule engine as others have it: a working memory of words, and rules that fire forwards
 * until nothing new follows. It knows nothing of plans.
 */
public final class ProductionRules implements Reasoner {
  private static final String GUIDED = "(guided Bob)";

  /** If all of these are in the working memory, then this is too. */
  private record Rule(Set<String> conditions, String conclusion) {}

  private static final List<Rule> RULES =
      List.of(
          new Rule(Set.of("somebody knows the way", "nobody has said hello"), "goal (greeted Bob)"),
          new Rule(Set.of(GUIDED), "somebody knows the way"),
          new Rule(Set.of("not (greeted Bob)"), "nobody has said hello"));

  @Override
  public String name() {
    return "production-rules";
  }

  @Override
  public List<Formula> wanted(Snapshot known) {
    Set<String> memory = new TreeSet<>();
    for (String fact : List.of(GUIDED, "(greeted Bob)")) {
      switch (known.truth((Formula.Atom) SlParser.formula(fact))) {
        case TRUE -> memory.add(fact);
        case FALSE -> memory.add("not " + fact);
        default -> memory.add("unknown " + fact);
      }
    }
    while (RULES.stream()
        .anyMatch(rule -> memory.containsAll(rule.conditions()) && memory.add(rule.conclusion()))) {
      // Until nothing new follows.
    }
    List<Formula> goals = new ArrayList<>();
    memory.stream()
        .filter(word -> word.startsWith("goal "))
        .forEach(word -> goals.add(SlParser.formula(word.substring("goal ".length()))));
    return goals;
  }
}
