package org.maestro.ontology.home;

import java.util.List;
import java.util.Optional;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** Reads the rules of a home; what cannot be read becomes a fault of the graph. */
final class RuleReader {
  static final Node PURSUES = Maestro.term("pursues");

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final Literals literals;

  RuleReader(SourceGraph graph, Vocabulary vocabulary) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.literals = new Literals(graph);
  }

  static boolean isRule(SourceGraph graph, Node node) {
    return graph.isA(node, Maestro.term("Rule"));
  }

  /** The rule; empty when it begins nothing, and its fault is noted. */
  Optional<Rule> read(Node node) {
    if (graph.objects(node, RDF.type.asNode()).size() > 1) {
      graph.fault(node, "is a rule and something else as well", "give the rule a name of its own");
    }
    List<Node> goals = List.copyOf(graph.objects(node, PURSUES));
    if (goals.size() != 1) {
      fault(
          node,
          goals.isEmpty() ? "is missing" : "is stated more than once",
          goals.isEmpty()
              ? "write what is to begin when, such as \"(whenever (open door) (greet))\""
              : "make a rule of each");
      return Optional.empty();
    }
    Optional<Formula> goal =
        literals.parsed(
            node, PURSUES, goals.get(0), text -> SlParser.formula(text, vocabulary::isFluent));
    if (goal.isPresent() && !(goal.get() instanceof Formula.Bound)) {
      fault(
          node,
          "is bound to no time and no event",
          "write when it is to begin, such as (whenever CONDITION GOAL), or (after 0 GOAL) for at"
              + " once");
    }
    return goal.filter(Formula.Bound.class::isInstance)
        .map(bound -> new Rule(Literals.name(node), literals.label(node), (Formula.Bound) bound));
  }

  private void fault(Node node, String problem, String cure) {
    graph.fault(node, PURSUES, Optional.empty(), problem, cure);
  }
}
