package org.maestro.ontology.home;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.sl.Body;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Occasion;

/** Checks the rules of a home: that each speaks of what there is, and of what its event binds. */
final class RuleCheck {
  /** Goals are counted so. */
  private static final String LIKE_AN_ID = "G[0-9]+|.*-[0-9]+";

  private final SourceGraph graph;
  private final Home home;

  RuleCheck(SourceGraph graph, Home home) {
    this.graph = graph;
    this.home = home;
  }

  void check(Map<String, Node> nodes) {
    if (nodes.isEmpty()) {
      return;
    }
    HomeCheck words = new HomeCheck(graph, home.vocabulary());
    nodes.values().forEach(words::checkScript);
    Offers offers = new Offers(graph, home);
    home.rules()
        .forEach(
            (name, rule) -> {
              Node node = HomeCheck.named(nodes, name);
              if (name.matches(LIKE_AN_ID)) {
                graph.fault(node, "has a name as goals have", "give the rule another name");
              }
              BodyCheck check =
                  new BodyCheck(home, offers, (problem, cure) -> fault(node, problem, cure));
              check(node, rule.goal(), Set.of(), check);
            });
  }

  /**
   * @param given what the events around it bind
   */
  private void check(Node node, Formula.Bound bound, Set<String> given, BodyCheck check) {
    Set<String> variables = new LinkedHashSet<>(given);
    if (bound.occasion() instanceof Occasion.Event event) {
      Set<String> own = FreeVariables.of(event.condition());
      check.names(untyped(own)).check(event.condition());
      if (bound instanceof Formula.Upon) {
        variables.addAll(own);
      }
    }
    Formula goal = bound.goal();
    if (goal instanceof Formula.Bound inner) {
      check(node, inner, variables, check);
      return;
    }
    for (String open : FreeVariables.of(goal)) {
      if (!variables.contains(open)) {
        fault(
            node,
            "begins a goal with ?%s, of which no condition of it speaks".formatted(open),
            "write a name in its place");
        variables.add(open);
      }
    }
    Optional<Script> script =
        goal instanceof Formula.Atom atom
            ? Optional.ofNullable(home.scripts().get(atom.predicate()))
            : Optional.empty();
    if (script.isPresent()) {
      check.check(
          new Body.Run(script.get().name(), ((Formula.Atom) goal).arguments()), untyped(variables));
    } else {
      check.names(untyped(variables)).check(goal);
    }
  }

  private static Map<String, List<String>> untyped(Set<String> variables) {
    Map<String, List<String>> untyped = new LinkedHashMap<>();
    variables.forEach(name -> untyped.put(name, List.of()));
    return untyped;
  }

  private void fault(Node node, String problem, String cure) {
    graph.fault(node, RuleReader.PURSUES, Optional.empty(), problem, cure);
  }
}
