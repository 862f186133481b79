package org.maestro.ontology.home;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.FeatureReader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.ontology.vocabulary.Reliability;
import org.maestro.ontology.vocabulary.Timing;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** Reads the action as which plans may use a script: that of one whose effect is stated. */
final class ScriptedAction {
  private static final Node EFFECT = Maestro.term("effect");
  private static final Node PRECONDITION = Maestro.term("precondition");
  private static final Node COST = Maestro.term("cost");
  private static final Expression NOTHING = new Expression.OfTerm(new Term.Number(0));

  private final SourceGraph graph;
  private final Vocabulary vocabulary;

  ScriptedAction(SourceGraph graph, Vocabulary vocabulary) {
    this.graph = graph;
    this.vocabulary = vocabulary;
  }

  Optional<FeatureType> read(Node node, List<TypedVariable> parameters) {
    if (graph.object(node, EFFECT).isEmpty()) {
      noEffect(node, PRECONDITION);
      noEffect(node, COST);
      return Optional.empty();
    }
    if (graph.object(node, COST).isEmpty()) {
      graph.fault(
          node,
          COST,
          Optional.empty(),
          "is missing beside maestro:effect",
          "write the seconds of work that the script takes, such as 30");
    }
    for (TypedVariable parameter : parameters) {
      if (parameter.className().filter(Parameter::isDatatype).isPresent()) {
        graph.fault(
            node,
            EFFECT,
            Optional.empty(),
            "is stated of a script over ?%s, for which a plan has no value to choose"
                .formatted(parameter.name()),
            "leave out the effect, or take only things for arguments");
      }
    }
    return Optional.of(
        new FeatureReader(graph, vocabulary::isFluent).read(node, blank(node, parameters)));
  }

  private void noEffect(Node node, Node property) {
    if (graph.object(node, property).isPresent()) {
      graph.fault(
          node,
          property,
          Optional.empty(),
          "is stated without maestro:effect",
          "state what the script brings about, so that plans may use it, or leave this out");
    }
  }

  private FeatureType blank(Node node, List<TypedVariable> parameters) {
    String name = Literals.name(node);
    return new FeatureType(
        name,
        node.getURI(),
        true,
        sentence(name, parameters),
        parameters.stream().map(ScriptedAction::input).toList(),
        List.of(),
        List.of(),
        new Formula.And(List.of()),
        new Effect.All(List.of()),
        Optional.empty(),
        false,
        Optional.empty(),
        OptionalDouble.empty(),
        Set.of(),
        List.of(),
        List.of(),
        new Price.Stated(NOTHING),
        NOTHING,
        Timing.USUAL,
        Reliability.USUAL,
        Optional.empty(),
        name,
        Map.of());
  }

  private static String sentence(String name, List<TypedVariable> parameters) {
    return "the script %s is run%s"
        .formatted(
            name,
            parameters.isEmpty()
                ? ""
                : parameters.stream()
                    .map(parameter -> "{" + parameter.name() + "}")
                    .collect(Collectors.joining(", ", " for ", "")));
  }

  private static Parameter input(TypedVariable parameter) {
    return new Parameter(
        parameter.name(), parameter.className().stream().toList(), List.of(), List.of(), false);
  }
}
