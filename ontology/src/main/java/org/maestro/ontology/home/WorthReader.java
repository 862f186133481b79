package org.maestro.ontology.home;

import java.time.Duration;
import java.util.Optional;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.sl.Expression;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** Reads what a script, or a goal that an agent has of its own accord, is worth (ADE, 4.1). */
final class WorthReader {
  private final SourceGraph graph;
  private final Literals literals;

  WorthReader(SourceGraph graph) {
    this.graph = graph;
    this.literals = new Literals(graph);
  }

  StatedWorth read(Node node) {
    return new StatedWorth(benefit(node), chance(node), allowed(node));
  }

  Optional<Expression> benefit(Node node) {
    Optional<Expression> benefit = literals.parsed(node, "benefit", SlParser::expression);
    if (benefit.isPresent()
        && benefit.get() instanceof Expression.OfTerm constant
        && constant.term() instanceof Term.Number number
        && number.value() < 0) {
      Node property = Maestro.term("benefit");
      graph.fault(
          node,
          property,
          graph.object(node, property),
          "is less than nothing",
          "write the seconds of work that it is worth, such as 60");
    }
    return benefit;
  }

  /** What is no number from 0 to 1 was noted when the shapes were checked. */
  Optional<Double> chance(Node node) {
    return graph
        .object(node, Maestro.term("chance"))
        .map(Literals::term)
        .filter(Term.Number.class::isInstance)
        .map(term -> ((Term.Number) term).value());
  }

  Optional<Duration> allowed(Node node) {
    Optional<Duration> allowed = literals.duration(node, "allowed");
    if (allowed.filter(time -> time.isNegative() || time.isZero()).isPresent()) {
      Node property = Maestro.term("allowed");
      graph.fault(
          node,
          property,
          graph.object(node, property),
          "leaves no time",
          "write days to seconds, such as PT10M");
    }
    return allowed;
  }
}
